/// The visitor of simulation state. An owner lists once everything that the next step depends on; checkpoints, fingerprints and programs
/// that use the library share this list.
///
///   template <class Visitor> void visit_state(Visitor&& visit) {
///     visit("velocity", std::span<double>(velocity_));   // a fixed number of values
///     visit("points_inside", inside_);                   // a std::vector of any length; a visitor that reads resizes it
///     visit("steps", steps_);                            // one number
///   }
///
/// A visitor reads or writes the numbers in place. Caches are not state: discarding them leaves all later results bitwise identical.
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

/// True for std::vector, whose length a visitor that reads may change.
template <class Values>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;

/// The numbers passed to a visitor, in any of the three forms.
template <class T>
std::span<T> numbers_in(std::span<T> values) {
  return values;
}
/// All values of a vector.
template <class T>
std::span<T> numbers_in(std::vector<T>& values) {
  return values;
}
/// One number as a span of length 1.
template <class T>
requires std::is_arithmetic_v<T> std::span<T> numbers_in(T& value) { return {&value, 1}; }

/// A visitor that prepends "prefix." to each name.
template <class Visitor>
auto under(std::string prefix, Visitor& visit) {
  return [prefix = std::move(prefix) + ".", &visit](std::string_view name, auto&& values) { visit(prefix + std::string(name), values); };
}

/// Visits members of structs as one array. `members` points to each of them; what the visitor writes is copied back.
template <class Visitor, std::size_t count>
void visit_members(Visitor& visit, std::string_view name, const std::array<double*, count>& members) {
  std::array<double, count> values;
  for (std::size_t k = 0; k < count; ++k) values[k] = *members[k];
  visit(name, std::span<double>(values));
  for (std::size_t k = 0; k < count; ++k) *members[k] = values[k];
}

/// Visits a vector as three numbers.
template <class Visitor>
void visit_vector(Visitor& visit, std::string_view name, Vec3d& vector) {
  visit_members(visit, name, std::array{&vector.x, &vector.y, &vector.z});
}

/// Visits a flag as one byte, 0 or 1.
template <class Visitor>
void visit_flag(Visitor& visit, std::string_view name, bool& flag) {
  std::uint8_t value = flag;
  visit(name, value);
  flag = value != 0;
}

/// A number that may be absent, visited as a list of zero or one entries.
template <class Visitor>
void visit_optional(Visitor& visit, std::string_view name, std::optional<double>& number) {
  std::vector<double> values;
  if (number) values.push_back(*number);
  visit(name, values);
  number = values.empty() ? std::nullopt : std::optional(values.front());
}

}  // namespace fccda
