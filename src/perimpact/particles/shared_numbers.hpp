/// Arrays of the state over the particles of a body that ranks share, for visitors of state (base/state.hpp). To other visitors they are spans.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/state.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Numbers of each eight slots: 8 of an array by slot, 1 of an array by eight.
template <class T>
struct EightNumbers : std::span<T> {
  EightNumbers(std::span<T> numbers, const Particles& particles, std::span<const std::size_t> begin_of_eight = {})
      : std::span<T>(numbers), share(&particles.share()), per_eight{.begin = begin_of_eight} {
    if (begin_of_eight.empty()) per_eight.each = numbers.size() / (particles.slots() / fccda::byte_lanes);
  }
  const Share* share;
  NumbersOfEights per_eight;
};

/// A visitor that passes all arrays on as numbers of the eights of a body.
template <class Visitor>
auto of_eights(const Particles& particles, Visitor& visit) {
  return [&](const auto& name, auto&& values) {
    if constexpr (requires { values.begin_of_eight; })
      visit(name, EightNumbers(fccda::numbers_in(values), particles, values.begin_of_eight));
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

}  // namespace perimpact
