/// What detection needs of a code that has points: a solver's own arrays are read in place through this interface, so the library
/// knows neither particles nor nodes.
#pragma once

#include <concepts>
#include <cstddef>

#include "base/vec3.hpp"

namespace fccda {

/// Points come in blocks of consecutive numbers, so that a few fast ones do not make all of them worth a look. The position at t0
/// of a step is the position at t1 of the step before; whoever breaks that tells the detector (`moved`).
/// The pose of the body at t0 is its pose at t1 of the step before; where it is not, exactly, the detector sees that by itself and looks
/// at all points again. The number of a point stands for it from step to step; numbers are appended and dropped at the end only, and
/// whoever gives points other numbers tells the detector (`Swept::renumbered`).
template <class P>
concept Points = requires(const P& points, std::size_t i) {
  { points.size() } -> std::convertible_to<std::size_t>;
  { points.position_t0(i) } -> std::convertible_to<Vec3d>;        // [m], world frame, at the beginning of the step
  { points.position_t1(i) } -> std::convertible_to<Vec3d>;        // [m] at its end
  { points.occupied(i) } -> std::convertible_to<bool>;            // false: there is no point i
  { points.block_count() } -> std::convertible_to<std::size_t>;   // blocks are in order and cover all points
  { points.block_begin(i) } -> std::convertible_to<std::size_t>;  // first point of block i
  { points.block_end(i) } -> std::convertible_to<std::size_t>;    // one past the last
  { points.block_travel(i) } -> std::convertible_to<double>;      // [m] no point of block i is further from its t0 position at t1
};

/// Points that are balls of different sizes; others all have the contact radius of their detector. Whoever lets a point grow tells the
/// detector (`moved`), for it may touch now what was beyond its reach.
template <class P>
concept PointsOfOwnRadius = Points<P> && requires(const P& points, std::size_t i) {
  { points.radius(i) } -> std::convertible_to<double>;         // [m], finite and at least 0
  { points.largest_radius() } -> std::convertible_to<double>;  // [m] that no point exceeds
};

template <Points P>
double contact_radius(const P& points, std::size_t i, double of_others) {
  if constexpr (PointsOfOwnRadius<P>)
    return points.radius(i);
  else
    return of_others;
}

}  // namespace fccda
