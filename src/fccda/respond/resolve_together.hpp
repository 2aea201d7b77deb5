/// Contact of several bodies with the same points in one step, by alternating passes (Gauss-Seidel).
///
/// All bodies have moved before. In the order given, each detects contact, relocates its points and takes their impulse. A point that one body
/// relocates may then lie inside another. Each body therefore resolves again the points that others relocated since its last pass, until no
/// contact is left. Two walls at an angle of 90° or more need two passes. Between closing walls (a vice, a narrow wedge) there may be no
/// admissible position. Points that are still inside a body after four passes are returned as unresolved penetrations; they are relocated in a
/// later step, once the other bodies leave clearance.
///
/// Each pass transfers momentum between points and bodies as with one body, so that momentum is conserved to rounding.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

#include "fccda/detect/contact.hpp"

namespace fccda {

/// Requirements on a body with its contact detection and response, for points of the type P.
template <class S, class P>
concept ContactResolver = requires(S& resolver, P& points, std::span<const std::size_t> which, std::size_t i) {
  { resolver.resolve_contact(points) } -> std::convertible_to<std::span<const Contact>>;               // detection and response; once per step
  { resolver.resolve_contact_again(points, which) } -> std::convertible_to<std::span<const Contact>>;  // the same for these points, in ascending order
  { resolver.still_inside(points, which) } -> std::convertible_to<std::vector<std::size_t>>;           // those that are inside at t1
  resolver.moved(i);                                                                                   // another body relocated point i
};

inline constexpr int max_passes = 4;

/// Returns the points of each body with unresolved penetration, in ascending order.
template <class S, class P>
requires ContactResolver<S, P> std::vector<std::vector<std::size_t>> resolve_together(std::span<S> resolvers, P& points) {
  std::vector<std::vector<std::size_t>> moved(resolvers.size());  // by others, since the last pass of this one
  std::vector<std::size_t> looked(resolvers.size(), 0);           // whether each has had its first pass in this step
  const auto notify_others = [&](std::size_t resolver, std::span<const Contact> contacts) {
    for (std::size_t other = 0; other < resolvers.size(); ++other) {
      if (other == resolver) continue;
      for (const Contact& contact : contacts) {
        resolvers[other].moved(contact.point);
        if (looked[other]) moved[other].push_back(contact.point);
      }
    }
  };
  for (std::size_t s = 0; s < resolvers.size(); ++s) {
    looked[s] = 1;
    notify_others(s, resolvers[s].resolve_contact(points));
  }
  for (int pass = 2; pass <= max_passes; ++pass) {
    for (std::size_t s = 0; s < resolvers.size(); ++s) {
      if (moved[s].empty()) continue;
      std::vector<std::size_t> which;
      which.swap(moved[s]);
      std::sort(which.begin(), which.end());
      which.erase(std::unique(which.begin(), which.end()), which.end());
      notify_others(s, resolvers[s].resolve_contact_again(points, which));
    }
  }
  for (std::size_t s = 0; s < resolvers.size(); ++s) {
    std::sort(moved[s].begin(), moved[s].end());
    moved[s].erase(std::unique(moved[s].begin(), moved[s].end()), moved[s].end());
    if (!moved[s].empty()) moved[s] = resolvers[s].still_inside(points, moved[s]);
  }
  return moved;
}

}  // namespace fccda
