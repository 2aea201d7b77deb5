/// Several bodies that strike the same points in one step.
///
/// All have moved when this begins. They act in the order given: each detects, relocates the points it struck and takes their impulse.
/// What one puts out of itself may then be inside another; so each looks again at the points that others moved since it looked, until
/// nothing is struck any more. Two walls that meet at a right angle or a wider one are done with the second pass. Where they are closing
/// in on a point (a vice, a narrow wedge) there may be no place outside of all; after four passes what is left inside one is pinched, and
/// returned. It is put out of it as soon as the others let it.
///
/// Every pass gives to the bodies what it takes from the points, so momentum is kept as by one body alone.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

#include "fccda/detect/contact.hpp"

namespace fccda {

/// A body with its detector and its response, against points of the type P.
template <class S, class P>
concept ContactResolver = requires(S& resolver, P& points, std::span<const std::size_t> which, std::size_t i) {
  { resolver.resolve_contact(points) } -> std::convertible_to<std::span<const Contact>>;               // detects and responds; once a step
  { resolver.resolve_contact_again(points, which) } -> std::convertible_to<std::span<const Contact>>;  // the same for these points, in rising order
  { resolver.still_inside(points, which) } -> std::convertible_to<std::vector<std::size_t>>;           // which of them are inside at t1
  resolver.moved(i);                                                                                   // another one displaced point i
};

inline constexpr int max_passes = 4;

/// Returns the pinched points of each striker, in rising order.
template <class S, class P>
requires ContactResolver<S, P> std::vector<std::vector<std::size_t>> resolve_together(std::span<S> resolvers, P& points) {
  std::vector<std::vector<std::size_t>> moved(resolvers.size());  // by others, since this one looked
  std::vector<std::size_t> looked(resolvers.size(), 0);           // whether each has, in this step
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
