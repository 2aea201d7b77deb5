/// All boundary conditions of one body, in the order in which they act: loads, then what damps, then what holds, because a holder's force
/// makes up for all others (docs/theory/boundary_conditions.md).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fccda/rigid_body/step.hpp"
#include "perimpact/boundary_conditions/all_boundary_conditions.hpp"
#include "perimpact/boundary_conditions/boundary_condition_of.hpp"

namespace perimpact {

class BoundaryConditions {
 public:
  /// None.
  BoundaryConditions() = default;
  /// Throws SetupError, also where two hold the same particles in the same direction.
  BoundaryConditions(const BodySetup& body, const IsotropicElastic& elastic, const Particles& particles, const SlotsOfRegion& slots_of);

  /// One more, that code gives. Throws SetupError where one has this name already.
  void add(NamedBoundaryCondition boundary);

  bool is_empty() const { return all_.empty(); }
  std::span<const NamedBoundaryCondition> all() const { return all_; }
  std::span<NamedBoundaryCondition> all() { return all_; }

  /// Puts held particles where they are at that time.
  void set_initial_state(Particles& particles, double time, PrescribedDisplacement::Regime pace);

  /// Which bonds there are now: `broken_ends` as InternalForce counts them. Before add_forces().
  void update_exposed_surface(const Particles& particles, const Family& family, std::span<const std::size_t> broken_ends);

  /// Forces at the beginning of the step that comes, added to those of the bonds.
  void add_forces(Particles& particles, const fccda::Step& next);

  /// After the particles were advanced: held ones go where they are led. `travel`: of advance().
  void impose_displacements(Particles& particles, const fccda::Step& step, std::span<double> travel);

  /// After contact: held ones go back. Slots that contact had displaced, in rising order of each boundary.
  std::vector<std::uint32_t> reimpose_after_contact(Particles& particles, const fccda::Step& step);

  /// In search of equilibrium: adds the loads of that time to the forces of the bonds, and takes the forces on held directions away.
  /// Returns how large loads and holding forces are [N], the root of the sum of their squares.
  double balance(Particles& particles, double time);

  /// Once equilibrium is found after dt [s]: the forces of the latest balance() are those of the state.
  void accept_equilibrium(const Particles& particles, double time, double dt);

  /// [J] of all loads and own forces, as Load::half_kick() says.
  double half_kick(double time, double dt) const;

  double work() const;                        ///< [J] of all, done on the body so far
  double constraint_work_correction() const;  ///< [J] of all holders, as Held::undone() says

  template <class Visitor>
  void visit_record(Visitor&& visit) {
    for (NamedBoundaryCondition& one : all_) std::visit([&](auto& boundary) { boundary.visit_record(one.name, visit); }, one.boundary);
  }

 private:
  template <class Kind, class Act>
  void for_each(const Act& accumulate_impulse);
  void refuse_floating_twice(const BodySetup& body, const Particles& particles) const;
  void refuse_constrained_twice(const BodySetup& body, const Particles& particles) const;

  std::vector<NamedBoundaryCondition> all_;
  std::vector<ForceSum> balanced_;  // of each, of the latest balance()
};

}  // namespace perimpact
