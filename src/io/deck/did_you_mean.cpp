#include "io/deck/did_you_mean.hpp"

#include <fmt/format.h>

namespace perimpact::deck {

std::string suggestion(std::string_view word, std::span<const std::string> words) {
  if (const std::string_view meant = nearest_word(word, words); !meant.empty()) return fmt::format("did you mean {}?", meant);
  return words.empty() ? "nothing is known here." : fmt::format("known here: {}.", fmt::join(words, ", "));
}

}  // namespace perimpact::deck
