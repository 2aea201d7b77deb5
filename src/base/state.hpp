/// How state is named: an owner says once what the next step depends on, for all who want to know it (fingerprints, checkpoints, programs
/// that use the library).
///
///   template <class Visitor> void visit_state(Visitor&& visit) {
///     visit("velocity", std::span<double>(velocity_));   // a fixed number of values
///     visit("points_inside", inside_);                   // a std::vector: as many as there are; a visitor that reads gives it its length
///     visit("steps", steps_);                            // one number
///   }
///
/// A visitor looks at the numbers or writes them, as they lie in memory. Caches are not state: dropping them changes no bit of what follows.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/vec3.hpp"

namespace fccda {

template <class Values>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;

/// The numbers that a visitor was given, whichever of the three forms they have.
template <class T>
std::span<T> numbers_in(std::span<T> values) {
  return values;
}
template <class T>
std::span<T> numbers_in(std::vector<T>& values) {
  return values;
}
template <class T>
requires std::is_arithmetic_v<T> std::span<T> numbers_in(T& value) { return {&value, 1}; }

/// A visitor that puts "prefix." before each name.
template <class Visitor>
auto under(std::string prefix, Visitor& visit) {
  return [prefix = std::move(prefix) + ".", &visit](std::string_view name, auto&& values) { visit(prefix + std::string(name), values); };
}

/// Members of structs as one array: `members` says where each of them is. What the visitor writes is taken over.
template <class Visitor, std::size_t count>
void visit_members(Visitor& visit, std::string_view name, const std::array<double*, count>& members) {
  std::array<double, count> values;
  for (std::size_t k = 0; k < count; ++k) values[k] = *members[k];
  visit(name, std::span<double>(values));
  for (std::size_t k = 0; k < count; ++k) *members[k] = values[k];
}

template <class Visitor>
void visit_vector(Visitor& visit, std::string_view name, Vec3d& vector) {
  visit_members(visit, name, std::array{&vector.x, &vector.y, &vector.z});
}

template <class Visitor>
void visit_flag(Visitor& visit, std::string_view name, bool& flag) {
  std::uint8_t value = flag;
  visit(name, value);
  flag = value != 0;
}

/// A number that may be absent, as a list of one or none.
template <class Visitor>
void visit_optional(Visitor& visit, std::string_view name, std::optional<double>& number) {
  std::vector<double> values;
  if (number) values.push_back(*number);
  visit(name, values);
  number = values.empty() ? std::nullopt : std::optional(values.front());
}

}  // namespace fccda
