/// Utilities shared by the text readers.
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace fccda {

inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  ///< some editors put it at the start of UTF-8 files

/// The entire word as a number, in any notation that C++ reads; nothing where it is not a number or out of range. Infinities are accepted.
template <class Number>
std::optional<Number> parsed(std::string_view word) {
  Number value{};
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_whole = problem == std::errc{} && end == word.data() + word.size();
  return is_whole ? std::optional(value) : std::nullopt;
}

/// The word without a leading plus sign, which std::from_chars rejects.
inline std::string_view without_plus(std::string_view word) { return word.starts_with('+') && !word.starts_with("+-") ? word.substr(1) : word; }

inline std::string_view trimmed(std::string_view text, std::string_view blanks = " \t") {
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string_view::npos ? std::string_view{} : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// The text with ? for unprintable bytes, for reports and messages.
inline std::string printable(std::string_view text) {
  std::string out(text);
  std::replace_if(
      out.begin(), out.end(), [](char c) { return (c >= '\0' && c < ' ') || c == '\x7f'; }, '?');
  return out;
}

}  // namespace fccda
