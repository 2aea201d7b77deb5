/// A deformable body: its particles, their bonds, and what the bonds do.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "perimpact/body/failure.hpp"
#include "perimpact/body/initial_cracks.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/discretise.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/materials/internal_force.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

struct Body {
  std::string name;
  Particles particles;
  Family family;
  InternalForce internal;
  std::optional<FailureCriterion> failure = {};  ///< nothing where bonds never break
  std::vector<CrackCut> cracks = {};             ///< that were there from the start
  std::optional<double> bending = {};            ///< k_b that all bonds are stiffer by, where the set-up has the bending stiffness made right

  /// Momentum [kg m/s] of all particles, summed in blocks, in order.
  Vec3d momentum() const;
  /// [J]; velocities are brought from the middle of the step to its end with the present forces: v + f dt/(2ρ).
  double kinetic_energy(double dt) const;
  /// [J] ½ Σ m v_{n-1/2}·v_{n+1/2}: with the elastic energy of linear bonds this is constant to rounding, where the other has a ripple of (ω dt)²
  /// (docs/theory/energy.md).
  double kinetic_energy_of_scheme(double dt) const;
  double memory() const;  ///< [bytes] of its arrays

  template <class Visitor>
  void visit_state(Visitor&& visit) {
    particles.visit_state(name, visit);
    family.visit_state(name, visit);
    internal.visit_state(name, visit);
  }

  /// What was only noted, and changes no step.
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    internal.visit_record(name, visit);
  }
};

/// The particles that fill the solid, or those of the cloud, with their first velocities. Throws SetupError where there are none, or too many to be
/// numbered.
Particles make_particles(const BodySetup& setup, const Discretisation& discretisation);
inline Particles make_particles(const BodySetup& setup) { return make_particles(setup, discretise(setup)); }

/// Elastic constants of its material, in space or in its plane.
IsotropicElastic elastic_of(const BodySetup& setup);

/// How a body that is thin along an axis bends, before any calibration.
struct BendingOfLayers {
  std::size_t axis;
  int layers;
  double relative;  ///< bending stiffness over that of a plate
};

/// Of a body on a lattice, four times as wide as thick; nothing of others, and none of the model correspondence.
std::optional<BendingOfLayers> bending_of_thin(const BodySetup& setup, const Particles& particles);

/// The body of these particles: its bonds and surface corrections are those of the particles that are there, and cracks are cut after. Throws
/// SetupError where a crack cannot be cut.
Body make_body(const BodySetup& setup, Particles particles);
inline Body make_body(const BodySetup& setup) { return make_body(setup, make_particles(setup)); }

}  // namespace perimpact
