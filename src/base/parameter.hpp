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
#include <utility>
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

namespace detail {

/// The name of an enumerator, or a number where `value` is none: "… [with auto value = perimpact::Plane::stress]" of GCC, "[value = …]" of Clang.
template <auto value>
constexpr std::string_view enumerator_name() {
  std::string_view name = __PRETTY_FUNCTION__;
  name.remove_suffix(1);
  const std::size_t semicolon = name.find(';');
  if (semicolon != std::string_view::npos) name = name.substr(0, semicolon);
  return name.substr(name.find_last_of(":) ") + 1);
}

template <auto value>
constexpr bool is_spelt(std::string_view word) {
  const std::string_view name = enumerator_name<value>();
  if (name.size() != word.size()) return false;
  for (std::size_t k = 0; k < name.size(); ++k)
    if (name[k] != (word[k] == '-' ? '_' : word[k])) return false;
  return true;
}

}  // namespace detail

/// True if the words are the enumerators 0, 1, … of the enum, all of them and in their order, with `-` for `_`: then Choice::as<Enum>() is what the word says.
template <class Enum, std::size_t count>
constexpr bool are_enumerators(const std::string_view (&words)[count]) {
  const auto agree = [&]<std::size_t... k>(std::index_sequence<k...>) { return (detail::is_spelt<static_cast<Enum>(k)>(words[k]) && ...); };
  const bool is_whole = detail::enumerator_name<static_cast<Enum>(count)>()[0] <= '9';  // there is none of this number
  return is_whole && agree(std::make_index_sequence<count>());
}

/// A selection from a few words. `index` selects from `words`; `as` converts it to the enum beside whose words are_enumerators() is asserted.
struct Choice {
  std::span<const std::string_view> words;
  int index = 0;

  std::string_view word() const { return words[static_cast<std::size_t>(index)]; }
  template <class Enum>
  Enum as() const {
    return static_cast<Enum>(index);
  }
  /// The same for an enum that the deck model does not know, of another library.
  template <class Enum, const auto& its_words>
  Enum as() const {
    static_assert(are_enumerators<Enum>(its_words));
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
  std::string_view sentence;                     ///< its meaning, for `perimpact describe`
  std::span<const std::string_view> words = {};  ///< those that a list of words may contain; any where empty
};

}  // namespace fccda
