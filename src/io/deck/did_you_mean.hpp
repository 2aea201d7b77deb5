/// Suggestion of the intended word, as the end of a sentence.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/nearest_word.hpp"

namespace perimpact::deck {

using fccda::edits_between;
using fccda::nearest_word;

/// "did you mean spacing?", or, without a similar word, "known here: end, step."
std::string suggestion(std::string_view word, std::span<const std::string> words);

}  // namespace perimpact::deck
