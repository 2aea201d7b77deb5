/// The interface of detection to a code with points. The solver's arrays are read in place, so the library depends neither on particles nor on
/// nodes.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

#include "base/vec3.hpp"

namespace fccda {

/// Points are in blocks of consecutive numbers, so that a few fast ones do not make all of them due. The position at t0 of a step is the
/// position at t1 of the previous step; other displacements must be reported to the detector (`moved`).
/// The pose of the body at t0 is its pose at t1 of the previous step; if it differs at all, the detector notices and evaluates all points
/// again. A point keeps its number from step to step. Numbers are appended and removed at the end only, and not both between the same two steps; any
/// other renumbering must be reported to the detector (`Swept::renumbered`). A number that is not occupied is not looked at again: a point that comes to
/// occupy it must be reported to the detector (`moved`).
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

/// Points that are kept elsewhere, such as in the memory of a GPU. Detectors ask for those that they are about to read, in ascending order and outside of
/// parallel loops; a point that was fetched in a step is not changed by a further fetch in the same step.
template <class P>
concept RemotePoints = Points<P> && requires(const P& points, std::span<const std::size_t> which) {
  { points.is_remote() } -> std::convertible_to<bool>;  // false: all of them can be read
  points.fetch(which);
};

/// Fetches the points of these blocks for which is_read(block, point).
template <Points P, class IsRead>
void fetch_points(const P& points, std::span<const std::size_t> blocks, const IsRead& is_read) {
  if constexpr (RemotePoints<P>) {
    if (!points.is_remote()) return;
    std::vector<std::size_t> which;
    for (const std::size_t b : blocks)
      for (std::size_t i = points.block_begin(b); i < points.block_end(b); ++i)
        if (points.occupied(i) && is_read(b, i)) which.push_back(i);
    points.fetch(which);
  }
}

/// Fetches all points.
template <Points P>
void fetch_every_point(const P& points) {
  if constexpr (RemotePoints<P>) {
    if (!points.is_remote()) return;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points.occupied(i)) which.push_back(i);
    points.fetch(which);
  }
}

/// The contact radius of point i [m]: its own, or that of the detector.
template <Points P>
double contact_radius(const P& points, std::size_t i, double of_others) {
  if constexpr (PointsOfOwnRadius<P>)
    return points.radius(i);
  else
    return of_others;
}

}  // namespace fccda
