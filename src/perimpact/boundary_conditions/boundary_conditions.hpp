/// All boundary conditions of one body (docs/theory/boundary_conditions.md). An action has `account`, slots() and visit_record(), and takes part in
/// those phases of a step for which it has the member, in this order:
///
///   apply_load(particles, next)              forces that do not depend on the deformation, and user forces
///   apply_hydrostatics(particles)            forces of the position
///   damp(particles, dt)                      damping of the velocities by all forces so far
///   apply_resistance(particles, dt)          drag, and added mass, which scales all forces so far
///   apply_constraint(particles, next)        reactions, which balance all other forces
///
/// In relaxation they are static_load(particles, time), static_hydrostatics(particles) and constrain_statically(particles), each of which returns its
/// force; an action without them exerts none. flood_deep_columns(particles) follows an accepted equilibrium. conjugate_displacement(particles, time) is that
/// with which the force does work. leave_out(slots, axis) excludes directions that another boundary condition constrains. collectives_in_step(setup) are the
/// reductions of several ranks in its phases, which do not depend on the particles.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fccda/rigid_body/step.hpp"
#include "perimpact/boundary_conditions/named_boundary_condition.hpp"

namespace perimpact {

class BoundaryConditions {
 public:
  /// None.
  BoundaryConditions() = default;
  /// Throws SetupError, also if two constrain the same direction of the same particles.
  BoundaryConditions(const BodySetup& body, const IsotropicElastic& elastic, const Particles& particles, const SlotsOfRegion& slots_of);

  /// Adds a user-defined boundary condition. Throws SetupError if the name is in use.
  void add(NamedBoundaryCondition boundary);

  bool is_empty() const { return all_.empty(); }
  std::span<const NamedBoundaryCondition> all() const { return all_; }
  std::span<NamedBoundaryCondition> all() { return all_; }

  /// Sets positions and velocities of constrained particles at that time.
  void set_initial_state(Particles& particles, double time, PrescribedDisplacement::Regime pace);

  /// Updates exposed particles after bond failure; `broken_ends` as in InternalForce. To be called before add_forces().
  void update_exposed_surface(const Particles& particles, const Family& family, std::span<const std::uint32_t> broken_ends);

  /// Adds forces at the beginning of the next step to those of the bonds.
  void add_forces(Particles& particles, const fccda::Step& next);

  /// Imposes prescribed displacements after the particles were advanced. `travel`: of advance().
  void impose_displacements(Particles& particles, const fccda::Step& step, std::span<double> travel);

  /// To be called after contact, which has displaced the particles in the slots `changed`, each once or repeatedly: reimposes prescribed displacements, and
  /// excludes these particles from added mass. Returns those that were constrained, ascending per boundary condition. Collective.
  std::vector<std::uint32_t> respond_to_contact(Particles& particles, const fccda::Step& step, std::vector<std::uint32_t> changed);

  /// For relaxation: adds the loads of that time to the forces of the bonds, and removes the forces on constrained directions. Returns the
  /// 2-norm [N] of loads and reactions.
  double balance(Particles& particles, double time);

  /// Accepts the equilibrium after dt [s]: records the forces of the latest balance().
  void accept_equilibrium(const Particles& particles, double time, double dt);

  /// [J] of all loads and user forces, see Load::half_kick().
  double half_kick(double time, double dt) const;

  /// The body has other particles than in the last step: the change of their potential is no work.
  void restart_potentials();

  double work() const;                        ///< [J] cumulative, done on the body
  double constraint_work_correction() const;  ///< [J] of all constraints

  /// What the next step depends on beyond particles and bonds.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    const auto shared = with_share(visit);
    for (NamedBoundaryCondition& one : all_)
      std::visit(
          [&](auto& boundary) {
            if constexpr (requires { boundary.visit_state(one.name, shared); }) boundary.visit_state(one.name, shared);
          },
          one.boundary);
  }
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    for (NamedBoundaryCondition& one : all_) std::visit([&](auto& boundary) { boundary.visit_record(one.name, with_share(visit)); }, one.boundary);
  }

 private:
  template <class Visitor>
  auto with_share(Visitor& visit) const {
    return [this, &visit](const auto& name, auto&& values) {
      if constexpr (requires { values.slots; }) {
        auto numbers = values;
        numbers.share = &share_;
        visit(name, numbers);
      } else {
        visit(name, values);
      }
    };
  }
  template <class Act>
  void for_each(const Act& act);
  void refuse_floating_twice(const BodySetup& body, const Particles& particles) const;
  void refuse_constrained_twice(const BodySetup& body, const Particles& particles) const;

  Share share_;
  std::vector<NamedBoundaryCondition> all_;
  std::vector<ForceSum> balanced_;  // of each, of the latest balance()
};

}  // namespace perimpact
