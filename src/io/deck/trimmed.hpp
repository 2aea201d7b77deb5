/// Text without what stands about it.
#pragma once

#include <string_view>

namespace perimpact::deck {

/// `text` without the characters of `blanks` before it and after it.
inline std::string_view trimmed(std::string_view text, std::string_view blanks = " \t") {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// A cell of a CSV table: without blanks, the return of a line from elsewhere, and the quotes that spreadsheets put about names.
inline std::string_view trimmed_cell(std::string_view text) { return trimmed(text, " \t\r\""); }

}  // namespace perimpact::deck
