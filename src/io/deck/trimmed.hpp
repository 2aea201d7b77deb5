/// Trimming of text.
#pragma once

#include <string_view>

namespace perimpact::deck {

/// `text` without leading and trailing characters of `blanks`.
inline std::string_view trimmed(std::string_view text, std::string_view blanks = " \t") {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// A cell of a CSV table without blanks, carriage return (Windows line ends) and the quotes that spreadsheets add.
inline std::string_view trimmed_cell(std::string_view text) { return trimmed(text, " \t\r\""); }

}  // namespace perimpact::deck
