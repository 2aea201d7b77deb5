/// The word that was probably meant, as the end of a sentence.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/nearest_word.hpp"

namespace perimpact::deck {

using fccda::edits_between;
using fccda::nearest_word;

/// "did you mean spacing?", or, where nothing is near, "known here: end, step."
std::string suggestion(std::string_view word, std::span<const std::string> words);

}  // namespace perimpact::deck
