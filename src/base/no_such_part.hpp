/// The message for an unknown part name of a surface.
#pragma once

#include <algorithm>
#include <span>
#include <string>

#include "base/nearest_word.hpp"

namespace fccda {

/// `known`: the existing names; one empty name if the surface has no named parts.
inline std::string no_such_part(const std::string& part, std::span<const std::string> known) {
  std::string sentence = "the surface has no part \"" + part + "\"";
  if (const std::string_view meant = nearest_word(part, known); !meant.empty()) sentence += "; did you mean " + std::string(meant) + "?";
  if (known.size() == 1 && known[0].empty()) return sentence + "; its panels have no names, so omit the parts, or name them in its file.";
  sentence += sentence.ends_with('?') ? " Its parts are " : "; its parts are ";
  constexpr std::size_t most = 20;  // keeps the sentence readable for assemblies of thousands of parts
  for (std::size_t k = 0; k < std::min(known.size(), most); ++k) sentence += (k > 0 ? ", " : "") + (known[k].empty() ? "one without a name" : known[k]);
  return sentence + (known.size() > most ? " and " + std::to_string(known.size() - most) + " more." : ".");
}

}  // namespace fccda
