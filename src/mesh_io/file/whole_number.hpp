/// Whole numbers in text: counts, and numbers of vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesh_io/file/words.hpp"

namespace fccda {

/// The word as a whole number; throws InputError with the line of `words` for anything else. `what` is what the sentence calls it.
std::int64_t whole_number(const Words& words, std::string_view word, std::string_view what);

/// The same of a count, which is not negative.
std::size_t count_number(const Words& words, std::string_view word, std::string_view what);

}  // namespace fccda
