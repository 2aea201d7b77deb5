/// A deformable body: its particles, their bonds, and what the bonds do.
#pragma once

#include <optional>
#include <string>

#include "perimpact/family/family.hpp"
#include "perimpact/force/internal_force.hpp"
#include "perimpact/particles/particles.hpp"
#include "perimpact/setup/setup.hpp"
#include "perimpact/simulation/failure.hpp"

namespace perimpact {

struct Body {
  std::string name;
  Particles particles;
  Family family;
  InternalForce internal;
  std::optional<FailureCriterion> failure = {};  ///< nothing where bonds never break

  /// Momentum [kg m/s] of all particles, summed in blocks, in order.
  Vec3d momentum() const;
  /// [J]; velocities are brought from the middle of the step to its end with the present forces: v + f dt/(2ρ).
  double kinetic_energy(double dt) const;
  double memory() const;  ///< [bytes] of its arrays

  template <class Visitor>
  void visit_state(Visitor&& visit) {
    particles.visit_state(name, visit);
    family.visit_state(name, visit);
    internal.visit_state(name, visit);
  }
};

/// How many slots the lattice that fills the solid has: its cells, rows rounded up. A double, for there may be too many to count.
double slots_of(const BodySetup& setup);

/// Elastic constants of its material, in space or in its plane.
IsotropicElastic elastic_of(const BodySetup& setup);

/// The particles that fill the solid, with their first velocities. Throws SetupError where there are too many to be numbered.
Particles make_particles(const BodySetup& setup);

/// The body of these particles: its bonds and surface corrections are those of the particles that are there.
Body make_body(const BodySetup& setup, Particles particles);
inline Body make_body(const BodySetup& setup) { return make_body(setup, make_particles(setup)); }

}  // namespace perimpact
