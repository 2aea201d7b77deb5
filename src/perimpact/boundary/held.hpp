/// Particles of which one or more directions are held at rest or led along a course: the boundaries `fixed` and `prescribed`.
///
///   x(t1) = X + d(t1),    v = (d(t1) - d(t0))/dt        at the end of every step, to the bit
///
/// What holds them is a force like any other: at t_n it makes up the sum of forces that leads to the next velocity,
///   R = ρ V (v_{n+1/2} - v_{n-1/2})/dt - F            [N]
/// where F are the other forces, so that momentum, work and the kinetic energy at t_n come out as for all particles. In a state of
/// equilibrium R = -F. Contact does not move a held direction: what an impactor gives it is handed on to the holder (docs/theory/boundary_conditions.md).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fccda/body/step.hpp"
#include "perimpact/boundary/account.hpp"
#include "perimpact/boundary/course.hpp"
#include "perimpact/boundary/slot_sum.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

class Held {
 public:
  using Courses = std::array<std::optional<Course>, 3>;  ///< of x, y and z; free where absent

  /// `slots` ascending.
  Held(std::vector<std::uint32_t> slots, Courses courses) : slots_(std::move(slots)), courses_(std::move(courses)) {}

  std::span<const std::uint32_t> slots() const { return slots_; }
  bool holds(std::size_t axis) const { return courses_[axis].has_value(); }

  /// Puts the particles where they are at that time, with the velocities of just then or, for a state of equilibrium, without any.
  enum class Pace { moving, still };
  void place(Particles& particles, double time, Pace pace) const;

  /// After the particles were advanced. `travel`: what advance() wrote, raised where the course is longer.
  void lead(Particles& particles, const fccda::Step& step, std::span<double> travel) const;

  /// After contact, in the same step. Adds the slots that it had displaced to `displaced`.
  void lead_back(Particles& particles, const fccda::Step& step, std::vector<std::uint32_t>& displaced);

  /// Takes over the force density of the held directions for the step that comes: the last of all forces.
  ForceSum hold(Particles& particles, const fccda::Step& next) const;

  /// The same for a state of equilibrium: nothing is left for the held directions.
  ForceSum hold_still(Particles& particles) const;

  /// [m] of the held directions at that time.
  Vec3d displacement(double time) const;

  /// [J] what leading back did to particles beyond the work of the holder, so far: it undoes what contact is said to have done to them.
  double undone() const { return undone_; }

  BoundaryAccount account;

  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    account.visit_record(name, visit);
    visit(name + ".undone", std::span<double>(&undone_, 1));
  }

 private:
  template <class Target>
  ForceSum take_over(Particles& particles, const Target& target) const;

  std::vector<std::uint32_t> slots_;
  Courses courses_;
  double undone_ = 0;
};

}  // namespace perimpact
