/// The word that was probably meant.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace perimpact::deck {

/// Letters to insert, delete, replace or exchange with their neighbour until `a` is `b`; case and the choice between - and _ are free.
/// (Optimal string alignment: Damerau, Commun. ACM 7 (1964) 171.)
std::size_t edits_between(std::string_view a, std::string_view b);

/// The nearest of `words`, where it is near: at most one edit in three letters, or one begins with the other. Empty otherwise.
std::string_view nearest_word(std::string_view word, std::span<const std::string> words);

/// "did you mean spacing?", or, where nothing is near, "known here: end, step."
std::string suggestion(std::string_view word, std::span<const std::string> words);

}  // namespace perimpact::deck
