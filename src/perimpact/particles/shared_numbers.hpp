/// What arrays of the state belong to, for visitors of state (base/state.hpp) that know ranks and moving windows. To other visitors they are spans, lists and
/// numbers.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/state.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// What numbers of eights are.
enum class OfEights {
  values,  ///< of the material there
  bonds,   ///< bits of the bonds of the material there
  sums     ///< since the beginning, of all material that was there
};

/// Sums since the beginning, one of each eight, which stay there when a window moves, so that their totals include discarded material.
template <class T>
struct SumsSinceBeginning : std::span<T> {
  explicit SumsSinceBeginning(std::span<T> sums) : std::span<T>(sums) {}
  static constexpr OfEights kind = OfEights::sums;
};

/// Numbers of each eight slots: 8 of an array by slot, 1 of an array by eight.
template <class T>
struct EightNumbers : std::span<T> {
  EightNumbers(std::span<T> numbers, const Particles& particles, OfEights what = OfEights::values, std::span<const std::size_t> begin_of_eight = {})
      : std::span<T>(numbers), share(&particles.share()), per_eight{.begin = begin_of_eight}, kind(what) {
    if (begin_of_eight.empty()) per_eight.each = numbers.size() / (particles.slots() / fccda::byte_lanes);
  }
  const Share* share;
  NumbersOfEights per_eight;
  OfEights kind;
};

/// A visitor that passes all arrays on as numbers of the eights of a body.
template <class Visitor>
auto of_eights(const Particles& particles, Visitor& visit) {
  return [&](const auto& name, auto&& values) {
    if constexpr (requires { values.begin_of_eight; })
      visit(name, EightNumbers(fccda::numbers_in(values), particles, OfEights::bonds, values.begin_of_eight));
    else if constexpr (requires { values.kind; })
      visit(name, EightNumbers(fccda::numbers_in(values), particles, values.kind));
    else
      visit(name, EightNumbers(fccda::numbers_in(values), particles));
  };
}

/// Numbers of some owned slots, ascending, as many of each.
template <class T>
struct ListNumbers : std::span<T> {
  ListNumbers(std::span<T> numbers, std::span<const std::uint32_t> of_slots) : std::span<T>(numbers), slots(of_slots) {}
  std::span<const std::uint32_t> slots;
  const Share* share = nullptr;  // of the body; set by the boundary conditions of the body
};

/// A list that a visitor may resize.
template <class T>
class SharedList : public std::span<T> {
 public:
  explicit SharedList(std::vector<T>& list) : std::span<T>(list), list_(&list) {}
  void resize(std::size_t count) {
    list_->resize(count);
    static_cast<std::span<T>&>(*this) = *list_;
  }
  void assign(const std::vector<T>& numbers) {
    *list_ = numbers;
    static_cast<std::span<T>&>(*this) = *list_;
  }

 private:
  std::vector<T>* list_;
};

/// Owned slots of a body, ascending, that a detector has listed.
struct ListedPoints : SharedList<std::uint64_t> {
  ListedPoints(std::vector<std::uint64_t>& points, std::size_t of_body) : SharedList(points), body(of_body) {}
  std::size_t body;
};
/// Pairs in contact, each on one rank: the two ids of each.
struct EndsOfPairs : SharedList<std::uint64_t> {
  using SharedList::SharedList;
  static constexpr std::size_t per_pair = 2;
};
/// Numbers of each of these pairs; visited after their ends.
struct NumbersOfPairs : SharedList<double> {
  using SharedList::SharedList;
  static constexpr std::size_t per_pair = 3;
};

/// A count of a rank's own work; that of the run is the sum.
template <class T>
struct OwnCount : std::span<T> {
  explicit OwnCount(T& count) : std::span<T>(&count, 1) {}
  static constexpr bool is_own = true;
};

/// A visitor of the state of a detector against a body.
template <class Visitor>
auto of_detector(std::size_t body, Visitor& visit) {
  return [body, &visit](std::string_view name, auto& values) {
    if constexpr (fccda::is_list<std::remove_cvref_t<decltype(values)>>)
      visit(name, ListedPoints(values, body));
    else
      visit(name, values);
  };
}
/// A visitor of the record of a detector, which counts.
template <class Visitor>
auto of_counts(Visitor& visit) {
  return [&visit](std::string_view name, auto& count) { visit(name, OwnCount(count)); };
}

}  // namespace perimpact

namespace fccda {
template <class Values>
requires std::derived_from<Values, perimpact::SharedList<typename Values::value_type>>
inline constexpr bool is_list<Values> = true;
}  // namespace fccda
