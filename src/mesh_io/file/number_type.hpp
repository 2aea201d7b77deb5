/// Number types of binary files: ten types, in either byte order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/contract.hpp"

namespace fccda {

enum class NumberType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

constexpr bool is_whole(NumberType type) { return type < NumberType::float32; }

/// Calls `visit` with a zero of the given type.
template <class Visit>
constexpr decltype(auto) visit_type(NumberType type, const Visit& visit) {
  switch (type) {
    case NumberType::int8:
      return visit(std::int8_t{});
    case NumberType::uint8:
      return visit(std::uint8_t{});
    case NumberType::int16:
      return visit(std::int16_t{});
    case NumberType::uint16:
      return visit(std::uint16_t{});
    case NumberType::int32:
      return visit(std::int32_t{});
    case NumberType::uint32:
      return visit(std::uint32_t{});
    case NumberType::int64:
      return visit(std::int64_t{});
    case NumberType::uint64:
      return visit(std::uint64_t{});
    case NumberType::float32:
      return visit(float{});
    default:
      return visit(double{});
  }
}

constexpr std::size_t size_of(NumberType type) {
  return visit_type(type, [](auto zero) { return sizeof zero; });
}

/// The number that starts at `bytes`.
template <class Stored>
Stored number_at(const char* bytes, std::endian order) {
  std::array<char, sizeof(Stored)> raw;
  std::copy_n(bytes, raw.size(), raw.begin());
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Stored>(raw);
}

inline double real_at(const char* bytes, NumberType type, std::endian order) {
  return visit_type(type, [&](auto zero) { return static_cast<double>(number_at<decltype(zero)>(bytes, order)); });
}

/// All numbers in `bytes`, as double or std::int64_t; the latter for integer types only. Unsigned values beyond the signed 64-bit range become the
/// largest signed value, which is out of range for any index.
template <class Number>
std::vector<Number> numbers_in(std::string_view bytes, NumberType type, std::endian order) {
  EXPECTS(std::is_floating_point_v<Number> || is_whole(type));
  return visit_type(type, [&](auto zero) {
    using Stored = decltype(zero);
    std::vector<Number> out(bytes.size() / sizeof(Stored));
    for (std::size_t k = 0; k < out.size(); ++k) {
      const auto stored = number_at<Stored>(bytes.data() + k * sizeof(Stored), order);
      if constexpr (std::is_same_v<Stored, std::uint64_t> && std::is_integral_v<Number>) {
        out[k] = static_cast<Number>(std::min<std::uint64_t>(stored, std::numeric_limits<Number>::max()));
      } else {
        out[k] = static_cast<Number>(stored);
      }
    }
    return out;
  });
}

}  // namespace fccda
