/// The interface of detection to a code with points. The solver's arrays are read in place, so the library depends neither on particles nor on
/// nodes.
#pragma once

#include <concepts>
#include <cstddef>

#include "base/vec3.hpp"

namespace fccda {

/// Points are in blocks of consecutive numbers, so that a few fast ones do not make all of them due. The position at t0 of a step is the
/// position at t1 of the previous step; other displacements must be reported to the detector (`moved`).
/// The pose of the body at t0 is its pose at t1 of the previous step; if it differs at all, the detector notices and evaluates all points
/// again. A point keeps its number from step to step. Numbers are appended and removed at the end only; any other renumbering must be
/// reported to the detector (`Swept::renumbered`).
template <class P>
concept Points = requires(const P& points, std::size_t i) {
  { points.size() } -> std::convertible_to<std::size_t>;
  { points.position_t0(i) } -> std::convertible_to<Vec3d>;        // [m], world frame, at the beginning of the step
  { points.position_t1(i) } -> std::convertible_to<Vec3d>;        // [m] at its end
  { points.occupied(i) } -> std::convertible_to<bool>;            // false: there is no point i
  { points.block_count() } -> std::convertible_to<std::size_t>;   // blocks are in order and cover all points
  { points.block_begin(i) } -> std::convertible_to<std::size_t>;  // first point of block i
  { points.block_end(i) } -> std::convertible_to<std::size_t>;    // one past the last
  { points.block_travel(i) } -> std::convertible_to<double>;      // [m] bound of the displacement from t0 to t1 of points of block i
};

/// Points that are balls of individual radii; other points all have the contact radius of their detector. An increase of a radius must be
/// reported to the detector (`moved`), since the point may now be in contact.
template <class P>
concept PointsOfOwnRadius = Points<P> && requires(const P& points, std::size_t i) {
  { points.radius(i) } -> std::convertible_to<double>;         // [m], finite and at least 0
  { points.largest_radius() } -> std::convertible_to<double>;  // [m] upper bound of all radii
};

/// The contact radius of point i [m]: its own, or that of the detector.
template <Points P>
double contact_radius(const P& points, std::size_t i, double of_others) {
  if constexpr (PointsOfOwnRadius<P>)
    return points.radius(i);
  else
    return of_others;
}

}  // namespace fccda
