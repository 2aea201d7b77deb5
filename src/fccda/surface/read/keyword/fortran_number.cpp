#include "fccda/surface/read/keyword/fortran_number.hpp"

#include <charconv>
#include <cmath>
#include <string>

namespace fccda {
namespace {

template <class T>
std::optional<T> whole_number(std::string_view digits) {
  T value{};
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool is_whole = !digits.empty() && problem == std::errc{} && end == digits.data() + digits.size();
  return is_whole ? std::optional(value) : std::nullopt;
}

std::string_view without_plus(std::string_view word) { return word.starts_with('+') && !word.starts_with("+-") ? word.substr(1) : word; }

/// With the exponent as C++ reads it.
std::string with_e(std::string_view digits) {
  std::string out;
  for (const char c : digits) {
    const bool follows_mantissa = !out.empty() && ((out.back() >= '0' && out.back() <= '9') || out.back() == '.');
    if (c == 'd' || c == 'D') {
      out += 'e';
    } else {
      if ((c == '+' || c == '-') && follows_mantissa) out += 'e';
      out += c;
    }
  }
  return out;
}

}  // namespace

std::optional<double> fortran_real(std::string_view word) {
  const std::string_view digits = without_plus(word);
  std::optional<double> value = whole_number<double>(digits);
  constexpr std::size_t longest_field = 80;  // of a card
  if (!value && digits.size() <= longest_field) value = whole_number<double>(with_e(digits));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> fortran_integer(std::string_view word) { return whole_number<std::int64_t>(without_plus(word)); }

}  // namespace fccda
