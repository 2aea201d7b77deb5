/// Dirichlet condition: prescribed displacement of some directions of particles, the boundary conditions `fixed` and `prescribed`.
///
///   x(t1) = X + d(t1),    v = (d(t1) - d(t0))/dt        at the end of every step, bitwise exact
///
/// The reaction at t_n completes the sum of forces that yields the next velocity,
///   R = ρ V (v_{n+1/2} - v_{n-1/2})/dt - F            [N]
/// where F are the other forces, so that momentum, work and kinetic energy at t_n are those of any particle. In equilibrium R = -F. Contact
/// does not move a constrained direction: its impulse is transferred to the reaction (docs/theory/boundary_conditions.md).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fccda/rigid_body/step.hpp"
#include "perimpact/boundary_conditions/actions/action_kernels.hpp"
#include "perimpact/boundary_conditions/actions/displacement_history.hpp"
#include "perimpact/boundary_conditions/actions/force_sum.hpp"
#include "perimpact/boundary_conditions/actions/reaction_ledger.hpp"
#include "perimpact/particles/particles.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

class PrescribedDisplacement {
 public:
  using Histories = std::array<std::optional<DisplacementHistory>, 3>;  ///< of x, y and z; free where absent

  /// `slots` ascending.
  PrescribedDisplacement(std::vector<std::uint32_t> slots, Histories histories) : slots_(std::move(slots)), histories_(std::move(histories)) {}

  std::span<const std::uint32_t> slots() const { return slots_; }
  bool constrains(std::size_t axis) const { return histories_[axis].has_value(); }
  PrescribedMotion motion(const fccda::Step& step) const;

  /// Sets positions at that time, with the velocities at that time or, if quasi-static, zero velocities.
  enum class Regime { moving, quasi_static };
  void set_initial_state(Particles& particles, double time, Regime pace) const;

  /// Imposes the displacements after the particles were advanced. `travel`: of advance(), increased where necessary.
  void impose_displacements(Particles& particles, const fccda::Step& step, std::span<double> travel) const;

  /// Reimposes the displacements after contact, in the same step. `changed`: slots that contact has displaced, ascending. Appends those that were constrained
  /// to `displaced`.
  void reimpose_after_contact(Particles& particles, const fccda::Step& step, std::span<const std::uint32_t> changed, std::vector<std::uint32_t>& displaced);

  /// Replaces the force density of the constrained directions for the next step, after all other forces.
  ForceSum constrain(Particles& particles, const fccda::Step& next) const;
  void apply_constraint(Particles& particles, const fccda::Step& next) { record(next, constrain(particles, next).force); }
  void record(const fccda::Step& next, const Vec3d& reaction) { account.record_force(reaction, displacement(next.t0)); }

  /// The same for equilibrium: zero force on the constrained directions.
  ForceSum constrain_statically(Particles& particles) const;

  /// [m] of the constrained directions at that time.
  Vec3d displacement(double time) const;
  Vec3d conjugate_displacement(const Particles&, double time) const { return displacement(time); }

  /// [J] cumulative work of reimposing displacements beyond the constraint work; it compensates the work that contact recorded on them.
  double constraint_work_correction() const { return constraint_work_correction_; }

  /// Where contact displaces none of the particles.
  template <class Setup>
  static Traffic collectives_in_step(const Setup&) {
    Traffic traffic = reduction_of_sums<ForceSum>();
    return traffic += reduction_of(1);  // whether contact has displaced any
  }

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
