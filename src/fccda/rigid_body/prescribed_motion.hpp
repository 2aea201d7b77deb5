/// Prescribed motion of degrees of freedom of a rigid body, as functions of time.
///
/// A table contains velocities or displacements (piecewise_linear.hpp). In a step the body moves with the mean velocity,
///   v = 1/(t1 - t0) ∫ v(t) dt   or   v = (d(t1) - d(t0))/(t1 - t0),
/// so that at the end of every step it is at the prescribed position, up to rounding. Beyond the last time the last velocity continues, or
/// the last displacement stays. Displacements are relative to the position at t = 0: only differences matter.
///
/// A displacement of a rotation is an angle about one world axis. It determines the attitude only while the body rotates about no other axis,
/// because rotations do not commute.
#pragma once

#include <array>
#include <optional>

#include "fccda/rigid_body/piecewise_linear.hpp"
#include "fccda/rigid_body/rigid_body.hpp"
#include "fccda/rigid_body/step.hpp"

namespace fccda {

class PrescribedMotion {
 public:
  enum class Of { velocity, displacement };

  /// `degree` is numbered as in FreeDegrees: x, y, z, then the rotations about them. [m/s] or [m], [rad/s] or [rad].
  void prescribe(std::size_t degree, Of what, PiecewiseLinear table) { tables_[degree] = {what, std::move(table)}; }

  bool is_empty() const;

  /// The prescribed velocity of the degree at that time; `given` without a table.
  double velocity_at(std::size_t degree, double time, double given) const;

  /// The largest such value, in magnitude.
  double largest_velocity(std::size_t degree, double given) const;

  /// Sets the velocities for the step that begins. Expects the prescribed degrees to be constrained.
  void impose(RigidBody& body, const Step& step) const;

 private:
  struct Table {
    Of what;
    PiecewiseLinear table;
    double velocity(double t0, double t1) const { return what == Of::velocity ? table.mean(t0, t1) : table.slope(t0, t1); }
    double largest_velocity() const { return what == Of::velocity ? table.largest_value() : table.largest_slope(); }
  };
  std::array<std::optional<Table>, 6> tables_;
};

}  // namespace fccda
