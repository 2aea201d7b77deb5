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

#include "fccda/rigid_body/step.hpp"
#include "perimpact/boundary_conditions/displacement_history.hpp"
#include "perimpact/boundary_conditions/reaction_ledger.hpp"
#include "perimpact/boundary_conditions/slot_sum.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

class PrescribedDisplacement {
 public:
  using Histories = std::array<std::optional<DisplacementHistory>, 3>;  ///< of x, y and z; free where absent

  /// `slots` ascending.
  PrescribedDisplacement(std::vector<std::uint32_t> slots, Histories histories) : slots_(std::move(slots)), histories_(std::move(histories)) {}

  std::span<const std::uint32_t> slots() const { return slots_; }
  bool constrains(std::size_t axis) const { return histories_[axis].has_value(); }

  /// Puts the particles where they are at that time, with the velocities of just then or, for a state of equilibrium, without any.
  enum class Regime { moving, quasi_static };
  void set_initial_state(Particles& particles, double time, Regime pace) const;

  /// After the particles were advanced. `travel`: what advance() wrote, raised where the course is longer.
  void impose_displacements(Particles& particles, const fccda::Step& step, std::span<double> travel) const;

  /// After contact, in the same step. Adds the slots that it had displaced to `displaced`.
  void reimpose_after_contact(Particles& particles, const fccda::Step& step, std::vector<std::uint32_t>& displaced);

  /// Takes over the force density of the held directions for the step that comes: the last of all forces.
  ForceSum constrain(Particles& particles, const fccda::Step& next) const;

  /// The same for a state of equilibrium: nothing is left for the held directions.
  ForceSum constrain_statically(Particles& particles) const;

  /// [m] of the held directions at that time.
  Vec3d displacement(double time) const;

  /// [J] what leading back did to particles beyond the work of the holder, so far: it undoes what contact is said to have done to them.
  double constraint_work_correction() const { return constraint_work_correction_; }

  ReactionLedger account;

  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    account.visit_record(name, visit);
    visit(name + ".undone", std::span<double>(&constraint_work_correction_, 1));
  }

 private:
  template <class Target>
  ForceSum take_over(Particles& particles, const Target& target) const;

  std::vector<std::uint32_t> slots_;
  Histories histories_;
  double constraint_work_correction_ = 0;
};

}  // namespace perimpact
