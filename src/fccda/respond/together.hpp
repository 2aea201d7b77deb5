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
concept Striker = requires(S& striker, P& points, std::span<const std::size_t> which, std::size_t i) {
  { striker.strike(points) } -> std::convertible_to<std::span<const Contact>>;               // detects and responds; once a step
  { striker.strike_again(points, which) } -> std::convertible_to<std::span<const Contact>>;  // the same for these points, in rising order
  { striker.still_inside(points, which) } -> std::convertible_to<std::vector<std::size_t>>;  // which of them are inside at t1
  striker.moved(i);                                                                          // another one displaced point i
};

inline constexpr int most_passes = 4;

/// Returns the pinched points of each striker, in rising order.
template <class S, class P>
requires Striker<S, P> std::vector<std::vector<std::size_t>> strike_together(std::span<S> strikers, P& points) {
  std::vector<std::vector<std::size_t>> moved(strikers.size());  // by others, since this one looked
  std::vector<std::size_t> looked(strikers.size(), 0);           // whether each has, in this step
  const auto tell_others = [&](std::size_t striker, std::span<const Contact> contacts) {
    for (std::size_t other = 0; other < strikers.size(); ++other) {
      if (other == striker) continue;
      for (const Contact& contact : contacts) {
        strikers[other].moved(contact.point);
        if (looked[other]) moved[other].push_back(contact.point);
      }
    }
  };
  for (std::size_t s = 0; s < strikers.size(); ++s) {
    looked[s] = 1;
    tell_others(s, strikers[s].strike(points));
  }
  for (int pass = 2; pass <= most_passes; ++pass) {
    for (std::size_t s = 0; s < strikers.size(); ++s) {
      if (moved[s].empty()) continue;
      std::vector<std::size_t> which;
      which.swap(moved[s]);
      std::sort(which.begin(), which.end());
      which.erase(std::unique(which.begin(), which.end()), which.end());
      tell_others(s, strikers[s].strike_again(points, which));
    }
  }
  for (std::size_t s = 0; s < strikers.size(); ++s) {
    std::sort(moved[s].begin(), moved[s].end());
    moved[s].erase(std::unique(moved[s].begin(), moved[s].end()), moved[s].end());
    if (!moved[s].empty()) moved[s] = strikers[s].still_inside(points, moved[s]);
  }
  return moved;
}

}  // namespace fccda
