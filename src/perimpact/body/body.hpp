/// A deformable body: particles, bonds and internal forces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/timers.hpp"
#include "perimpact/body/failure.hpp"
#include "perimpact/body/initial_cracks.hpp"
#include "perimpact/body/motion_sums.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/discretisation/discretise.hpp"
#include "perimpact/family/cloud_parts.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/materials/internal_force.hpp"
#include "perimpact/particles/particles.hpp"
#include "perimpact/particles/partition.hpp"
#include "perimpact/particles/shared_numbers.hpp"

namespace perimpact {

struct Body {
  std::string name;
  Particles particles;
  Family family;
  InternalForce internal;
  std::optional<FailureCriterion> failure = {};  ///< empty if bonds never break
  std::vector<CrackCut> cracks = {};             ///< initial cracks
  std::optional<double> bending = {};            ///< factor k_b of all bond stiffnesses, with bending_calibration

  /// `dt` [s]: of the last step.
  MotionSums motion(double dt = 0) const;
  double memory() const;  ///< [bytes] of its arrays

  template <class Visitor>
  void visit_state(Visitor&& visit) {
    auto shared = of_eights(particles, visit);
    particles.visit_state(name, shared);
    family.visit_state(name, shared);
    internal.visit_state(name, shared);
    internal.derive_from_state(particles, family);
  }

  /// Recorded data that do not affect any step.
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    internal.visit_record(name, of_eights(particles, visit));
  }
};

/// Particles that fill the solid, or those of the cloud, with their initial velocities; the share of this rank. Throws SetupError if there are none, or more
/// than can be indexed. `first_rank`: see Share.
Particles make_particles(const BodySetup& setup, const Discretisation& discretisation, Ranks& ranks = alone(), int first_rank = 0,
                         const MeasuredLoad& load = {});
inline Particles make_particles(const BodySetup& setup) { return make_particles(setup, discretise(setup)); }
/// The same of a solid on a lattice of which this rank has that share.
Particles make_particles(const BodySetup& setup, Share share);

/// How ranks divide its lattice: not across z where it floats, since the water under it acts on columns.
PartitionRule partition_rule_of(const BodySetup& setup, const Lattice& whole, const MeasuredLoad& load = {});

/// How ranks divide its point cloud. `first_rank`: see Share.
CloudParts parts_of(const BodySetup& setup, const Cloud& cloud, int ranks, int first_rank, const MeasuredLoad& load = {});

/// Elastic constants of its material, 3-D or 2-D.
IsotropicElastic elastic_of(const BodySetup& setup);

/// Bending of a body that is thin along an axis, before calibration.
struct BendingOfLayers {
  std::size_t axis;
  int layers;
  double relative;  ///< bending stiffness over that of a plate
};

/// For a body on a lattice at least four times as wide as thick; empty for others and for the model correspondence.
std::optional<BendingOfLayers> bending_of_thin(const BodySetup& setup, const Particles& particles);

/// Axis across which the layers are calibrated, with bending_calibration.
inline std::size_t axis_of_calibration(const BodySetup& setup) { return static_cast<std::size_t>(setup.bending_calibration.index) - 1; }
/// Factor k_b on the stiffness of all bonds with which so many layers bend as a plate. Throws SetupError if they cannot be calibrated.
double bending_calibration(const BodySetup& setup, int layers);

/// Builds the body of these particles: bonds and surface correction first, then initial cracks. Throws SetupError if a crack cannot be cut.
Body make_body(const BodySetup& setup, Particles particles, fccda::Stages& stages);
inline Body make_body(const BodySetup& setup, Particles particles) {
  fccda::Stages unseen;
  return make_body(setup, std::move(particles), unseen);
}
inline Body make_body(const BodySetup& setup) { return make_body(setup, make_particles(setup)); }

}  // namespace perimpact
