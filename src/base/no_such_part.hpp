/// What to say where a part of a surface is named that is none.
#pragma once

#include <algorithm>
#include <span>
#include <string>

#include "base/nearest_word.hpp"

namespace fccda {

/// `known`: the names that there are; one empty name where the surface has no named parts.
inline std::string no_such_part(const std::string& part, std::span<const std::string> known) {
  std::string sentence = "the surface has no part \"" + part + "\"";
  if (const std::string_view meant = nearest_word(part, known); !meant.empty()) sentence += "; did you mean " + std::string(meant) + "?";
  if (known.size() == 1 && known[0].empty()) return sentence + "; its panels have no names, so leave the parts out, or name them in its file.";
  sentence += sentence.ends_with('?') ? " Its parts are " : "; its parts are ";
  constexpr std::size_t most = 20;  // so that an assembly of thousands stays a sentence
  for (std::size_t k = 0; k < std::min(known.size(), most); ++k) sentence += (k > 0 ? ", " : "") + (known[k].empty() ? "one without a name" : known[k]);
  return sentence + (known.size() > most ? " and " + std::to_string(known.size() - most) + " more." : ".");
}

}  // namespace fccda
