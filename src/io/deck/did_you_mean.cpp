#include "io/deck/did_you_mean.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace perimpact::deck {

namespace {

std::string folded(std::string_view word) {
  std::string out(word);
  for (char& c : out) c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

}  // namespace

std::size_t edits_between(std::string_view first, std::string_view second) {
  const std::string a = folded(first), b = folded(second);
  // rows of the table of distances between the first i letters of a and the first j of b
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

std::string_view nearest_word(std::string_view word, std::span<const std::string> words) {
  constexpr std::size_t longest_compared = 64;  // no key is longer, and the table grows with the square
  if (word.empty() || word.size() > longest_compared) return {};
  std::string_view nearest;
  std::size_t fewest = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : words) {
    const std::size_t edits = edits_between(word, candidate);
    if (edits < fewest) nearest = candidate, fewest = edits;
  }
  if (!nearest.empty()) return nearest;
  const std::string start = folded(word);
  constexpr std::size_t telling = 3;  // fewer letters begin too many words
  for (const std::string& candidate : words) {
    const std::string whole = folded(candidate);
    if (std::min(start.size(), whole.size()) >= telling && (whole.starts_with(start) || start.starts_with(whole))) return candidate;
  }
  return {};
}

std::string suggestion(std::string_view word, std::span<const std::string> words) {
  if (const std::string_view meant = nearest_word(word, words); !meant.empty()) return fmt::format("did you mean {}?", meant);
  return words.empty() ? "nothing is known here." : fmt::format("known here: {}.", fmt::join(words, ", "));
}

}  // namespace perimpact::deck
