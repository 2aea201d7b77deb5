/// Integers in text: counts and vertex numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesh_io/file/words.hpp"

namespace fccda {

/// The word as an integer; throws InputError with the line of `words` for anything else. `what` names the quantity in the message.
std::int64_t whole_number(const Words& words, std::string_view word, std::string_view what);

/// The same for a count, which must not be negative.
std::size_t count_number(const Words& words, std::string_view word, std::string_view what);

}  // namespace fccda
