/// The pairs of a list (near_pairs.hpp), for host and device.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace perimpact {

inline constexpr std::uint32_t no_bond = std::numeric_limits<std::uint32_t>::max();

/// Arrays by member, and by pair from first_pair of each member on. Its pairs without an intact bond come first, in the order of members.
struct PairsView {
  const std::size_t* first_pair;
  const std::uint32_t* counts;
  std::uint32_t* unbonded_counts;
  const std::uint8_t* is_exposed;
  std::int32_t* others;  // the other members
  std::uint32_t* bonds;  // row of the bond in the family of the member's eight slots if it is intact; else no_bond

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    visit(first_pair), visit(counts), visit(unbonded_counts), visit(is_exposed), visit(others), visit(bonds);
  }
};

}  // namespace perimpact
