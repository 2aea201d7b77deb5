#include "mesh_io/keyword/fortran_number.hpp"

#include <cmath>
#include <string>

#include "mesh_io/file/text.hpp"

namespace fccda {
namespace {

/// The number with its exponent in C++ notation.
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
  std::optional<double> value = parsed<double>(digits);
  constexpr std::size_t longest_field = 80;  // of a card
  if (!value && digits.size() <= longest_field) value = parsed<double>(with_e(digits));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> fortran_integer(std::string_view word) { return parsed<std::int64_t>(without_plus(word)); }

}  // namespace fccda
