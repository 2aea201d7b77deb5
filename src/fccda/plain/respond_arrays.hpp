/// The response as a plain call: struck points are put back on the surface, get their new velocities, and the body their impulse
/// (respond/respond.hpp has the equations).
#pragma once

#include <concepts>
#include <optional>
#include <ranges>
#include <span>

#include "fccda/plain/vectors.hpp"
#include "fccda/respond/respond.hpp"

namespace fccda {

/// One mass for all points, or one for each [kg].
class Masses {
 public:
  Masses(double of_all) : of_all_(of_all) {}
  template <std::ranges::contiguous_range Range>
  requires std::convertible_to<Range&, std::span<const double>> Masses(Range&& of_each) : of_each_(std::span<const double>(of_each)) {}

  double operator[](std::size_t i) const { return of_each_ ? (*of_each_)[i] : of_all_; }
  bool are_for(std::size_t count) const { return !of_each_ || of_each_->size() == count; }

 private:
  double of_all_ = 0;
  std::optional<std::span<const double>> of_each_;
};

/// The solver's arrays, in point order.
struct PointArrays {
  ConstVectors x_t0;  ///< [m]
  Vectors x_t1;       ///< [m] struck points are put back on the surface
  Vectors velocity;   ///< [m/s] that led from x_t0 to x_t1; of struck points the one that leads to where they are put back
  Masses mass;        ///< [kg]
};

/// Changes the points that struck and the body, and returns what the body got. `friction`: Coulomb's coefficient, 0 for none. Throws
/// InputError where the arrays differ in length or the step of the motion has no duration.
Tally respond(std::span<const Contact> contacts, const Motion& motion, RigidBody& body, const PointArrays& points, double friction = 0);

}  // namespace fccda
