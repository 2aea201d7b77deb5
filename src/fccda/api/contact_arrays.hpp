/// What the plain function calls for rigid and for deforming surfaces share: checks of arrays, and visitors of a detector's state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "fccda/api/contact_detector.hpp"
#include "fccda/api/respond_arrays.hpp"

namespace fccda {

/// Visitor of a detector's state that copies it into a struct.
struct StateReader {
  ContactDetector::State& state;
  void operator()(std::string_view name, const std::vector<std::uint64_t>& numbers) const {
    (name == "points_inside" ? state.inside : state.in_contact) = numbers;
  }
  void operator()(std::string_view, const std::uint64_t& renumbered) const { state.renumbered = renumbered; }
};

/// Visitors that write state and record of a detector from a struct.
struct StateWriter {
  const ContactDetector::State& state;
  void operator()(std::string_view name, std::vector<std::uint64_t>& numbers) const { numbers = name == "points_inside" ? state.inside : state.in_contact; }
  void operator()(std::string_view, std::uint64_t& renumbered) const { renumbered = state.renumbered; }
};
struct RecordWriter {
  const ContactDetector::State& state;
  void operator()(std::string_view name, std::uint64_t& count) const {
    if (name == "entered_inside") count = state.entered;
  }
};

/// The arrays that respond() modifies, as PointsInContact.
struct ContactArrays {
  const PointArrays& arrays;

  Vec3d position_t0(std::size_t i) const { return arrays.x_t0[i]; }
  Vec3d velocity(std::size_t i) const { return arrays.velocity[i]; }
  double mass(std::size_t i) const { return arrays.mass[i]; }
  void set(std::size_t i, const Vec3d& position, const Vec3d& velocity) const {
    arrays.x_t1.set(i, position);
    arrays.velocity.set(i, velocity);
  }
};

void expect_ordered(const ContactDetector::State& state);  ///< throws InputError
void expect_finite_positions(ConstVectors x);              ///< throws RunError
void expect_equally_long(const PointArrays& points);       ///< throws InputError
/// Throws InputError if a contact is not of a later point than the contact before. The two would be resolved as if each were the only one of its point:
/// the velocity of the point would change once, but its momentum be given twice.
void expect_later(std::size_t point, std::size_t point_before);
/// Throws InputError if a contact's point is none, or has no usable mass, and RunError if it has no usable velocity or position.
void expect_usable_point(const PointArrays& points, std::size_t point);

}  // namespace fccda
