/// Motion that is given against time, for degrees of freedom of a rigid body that are not free.
///
/// A table holds velocities or displacements (time_table.hpp). In a step the body moves with the mean velocity,
///   v = 1/(t1 - t0) ∫ v(t) dt   or   v = (d(t1) - d(t0))/(t1 - t0),
/// so that at the end of every step it is where the table says, but for rounding. Beyond the last time the last velocity goes on, or
/// the last displacement stays. Displacements count from where the body is at t = 0: only differences matter.
///
/// A displacement of a rotation is an angle about one axis of the world. It says where the body is only while the body turns about no
/// other axis, because rotations do not commute.
#pragma once

#include <array>
#include <optional>

#include "fccda/rigid_body/rigid_body.hpp"
#include "fccda/rigid_body/step.hpp"
#include "fccda/rigid_body/time_table.hpp"

namespace fccda {

class PrescribedMotion {
 public:
  enum class Of { velocity, displacement };

  /// `degree` counts as in FreeDegrees: x, y, z, then the rotations about them. [m/s] or [m], [rad/s] or [rad].
  void prescribe(std::size_t degree, Of what, TimeTable table) { tables_[degree] = {what, std::move(table)}; }

  bool is_empty() const;

  /// What the tables say instead of this `given` velocity of the degrees at that time.
  double velocity_at(std::size_t degree, double time, double given) const;

  /// The largest that they ever say, in magnitude.
  double largest_velocity(std::size_t degree, double given) const;

  /// Sets the velocities for the step that begins. Expects the prescribed degrees to be held by the body.
  void impose(RigidBody& body, const Step& step) const;

 private:
  struct Table {
    Of what;
    TimeTable table;
    double velocity(double t0, double t1) const { return what == Of::velocity ? table.mean(t0, t1) : table.slope(t0, t1); }
    double largest_velocity() const { return what == Of::velocity ? table.largest_value() : table.largest_slope(); }
  };
  std::array<std::optional<Table>, 6> tables_;
};

}  // namespace fccda
