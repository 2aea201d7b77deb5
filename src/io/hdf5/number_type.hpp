/// Number types of the simulation state and of output frames.
#pragma once

#include <cstdint>
#include <type_traits>

namespace perimpact::hdf5 {

enum class NumberType { uint8, int32, uint32, int64, uint64, float32, float64 };

template <class T>
constexpr NumberType number_type() {
  static_assert(std::is_arithmetic_v<T>);
  if constexpr (std::is_floating_point_v<T>) {
    static_assert(sizeof(T) == 4 || sizeof(T) == 8);
    return sizeof(T) == 4 ? NumberType::float32 : NumberType::float64;
  } else if constexpr (sizeof(T) == 1) {
    static_assert(std::is_same_v<T, std::uint8_t>, "one-byte numbers must be unsigned; see visit_flag");
    return NumberType::uint8;
  } else {
    static_assert(sizeof(T) == 4 || sizeof(T) == 8);
    if (sizeof(T) == 4) return std::is_signed_v<T> ? NumberType::int32 : NumberType::uint32;
    return std::is_signed_v<T> ? NumberType::int64 : NumberType::uint64;
  }
}

}  // namespace perimpact::hdf5
