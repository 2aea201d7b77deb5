/// Spelling suggestions for messages.
#pragma once

#include <algorithm>
#include <cctype>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fccda {

/// Lower case, with _ in place of -.
inline std::string folded_word(std::string_view word) {
  std::string out(word);
  for (char& c : out) c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// Edit distance: letters to insert, delete, replace or exchange with their neighbour until `first` equals `second`, irrespective of case
/// and of - or _. (Optimal string alignment: Damerau, Commun. ACM 7 (1964) 171.)
inline std::size_t edits_between(std::string_view first, std::string_view second) {
  const std::string a = folded_word(first), b = folded_word(second);
  // rows of the table of distances between the first i letters of a and the first j letters of b
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

/// The nearest of `words` if it is near: at most one edit in three letters, or one word begins with the other. Empty otherwise.
inline std::string_view nearest_word(std::string_view word, std::span<const std::string> words) {
  constexpr std::size_t longest_compared = 64;  // no key is longer, and the cost grows with the square
  if (word.empty() || word.size() > longest_compared) return {};
  std::string_view nearest;
  std::size_t fewest = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : words) {
    const std::size_t edits = edits_between(word, candidate);
    if (edits < fewest) nearest = candidate, fewest = edits;
  }
  if (!nearest.empty()) return nearest;
  const std::string start = folded_word(word);
  constexpr std::size_t telling = 3;  // fewer letters match too many words
  for (const std::string& candidate : words) {
    const std::string whole = folded_word(candidate);
    if (std::min(start.size(), whole.size()) >= telling && (whole.starts_with(start) || start.starts_with(whole))) return candidate;
  }
  return {};
}

}  // namespace fccda
