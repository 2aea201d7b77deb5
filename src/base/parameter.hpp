/// Described parameters: every struct that a deck can fill lists its fields once, with name, unit, range and a sentence.
/// The deck reader's checks, `perimpact describe` and the reference page are all generated from this list.
///
///   struct BoxSolid {
///     Vec3d size{};   // [m]
///     static std::span<const Field<BoxSolid>> fields();
///   };
///   std::span<const Field<BoxSolid>> BoxSolid::fields() {
///     static const Field<BoxSolid> all[] = {
///       {"size", &BoxSolid::size, "m", positive(), Presence::required, "Edge lengths in x, y and z."}};
///     return all;
///   }
///
/// The default of an optional field is the value in a default-constructed struct; it is defined nowhere else.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/vec3.hpp"

namespace fccda {

/// The allowed numbers. Applies to each component of a vector and each entry of a list.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_included = true;
  bool high_included = true;

  /// False for not-a-number and infinities as well.
  constexpr bool contains(double value) const {
    const bool above = low_included ? value >= low : value > low;
    const bool below = high_included ? value <= high : value < high;
    const bool finite = value - value == 0;
    return above && below && finite;
  }
};

constexpr Range any_number() { return {}; }
constexpr Range positive() { return {.low = 0, .low_included = false}; }
constexpr Range at_least(double low) { return {.low = low}; }
constexpr Range between(double low, double high) { return {.low = low, .high = high}; }
constexpr Range strictly_between(double low, double high) { return {low, high, false, false}; }

enum class Presence { required, optional };

/// A selection from a few words. `index` selects from `words`; `as` converts it to an enum.
struct Choice {
  std::span<const std::string_view> words;
  int index = 0;

  std::string_view word() const { return words[static_cast<std::size_t>(index)]; }
  template <class Enum>
  Enum as() const {
    return static_cast<Enum>(index);
  }
};

/// Description of one deck field of the struct T.
template <class T>
struct Field {
  using Member = std::variant<double T::*, std::optional<double> T::*, int T::*, std::optional<int> T::*, bool T::*, std::string T::*, Vec3d T::*,
                              std::optional<Vec3d> T::*, std::vector<double> T::*, std::vector<std::string> T::*, std::vector<Vec3d> T::*, Choice T::*>;

  std::string_view name;  ///< key in the deck
  Member member;          ///< where the value is stored; its type determines the accepted syntax
  std::string_view unit;  ///< SI unit of numbers ("m", "Pa", "m/s", "1" for pure numbers), empty for words
  Range range;
  Presence presence;
  std::string_view sentence;  ///< its meaning, for `perimpact describe`
};

}  // namespace fccda
