/// Small bodies for tests: every material, in space and in the plane, on a lattice, on the same points as a cloud, and on a shaken cloud.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "perimpact/body/body.hpp"

namespace fixtures {

using namespace perimpact;

enum class Model { ordinary_state, linear_solid, bond_based, correspondence };
enum class Points { lattice, listed, shaken };  ///< of the lattice; the same points with neighbour lists; a cloud of uneven points and volumes

struct BodyOptions {
  Vec3d size{0.02, 0.015, 0.009};
  double spacing = 0.001;
  double horizon_ratio = 3.015;
  double poissons_ratio = 0.25;
  SurfaceCorrection correction = SurfaceCorrection::automatic;
  FamilyRule family = FamilyRule::hu_ha_bobaru;
  Normalisation normalisation = Normalisation::lattice;
  std::optional<double> critical_stretch = {};
  Model model = Model::ordinary_state;
  Influence influence = Influence::inverse;  ///< of the linear solid and of correspondence
  StressLaw law = StressLaw::hencky;
  Stabilisation stabilisation = Stabilisation::bond_level;
  Plane plane = Plane::none;
  Points points = Points::lattice;
  std::optional<FailureSetup> failure = {};
};

inline constexpr double youngs_modulus = 191e9, density = 8000;

inline MaterialSetup material_setup(const BodyOptions& options) {
  const ElasticSetup elastic{youngs_modulus, options.poissons_ratio, density, options.critical_stretch};
  switch (options.model) {
    case Model::linear_solid: {
      LinearSolidSetup solid{elastic};
      solid.influence.index = static_cast<int>(options.influence);
      return solid;
    }
    case Model::bond_based:
      return BondBasedSetup{elastic};
    case Model::correspondence: {
      CorrespondenceSetup solid{elastic};
      solid.law.index = static_cast<int>(options.law);
      solid.stabilisation.index = static_cast<int>(options.stabilisation);
      solid.influence.index = static_cast<int>(options.influence);
      return solid;
    }
    default:
      return OrdinaryStateSetup{elastic};
  }
}

inline BodySetup body_setup(const BodyOptions& options = {}) {
  BodySetup setup;
  setup.name = "body";
  setup.shape = BoxSolid{options.size};
  setup.spacing = options.spacing;
  setup.horizon_ratio = options.horizon_ratio;
  setup.family.index = static_cast<int>(options.family);
  setup.normalisation.index = static_cast<int>(options.normalisation);
  setup.surface_correction.index = static_cast<int>(options.correction);
  setup.plane.index = static_cast<int>(options.plane);
  setup.material = material_setup(options);
  setup.failure = options.failure;
  return setup;
}

/// The particles of a lattice as a cloud; `uneven`: moved by up to this share of the spacing, with volumes that differ by as much.
inline Particles as_cloud(const Particles& lattice, double uneven, unsigned seed = 7) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> move(-uneven, uneven);
  Cloud cloud{.thickness = lattice.thickness()};
  for (const std::uint32_t slot : lattice.slot_of()) {
    const double h = lattice.spacing();
    cloud.points.push_back(lattice.reference(slot) + Vec3d{h * move(random), h * move(random), lattice.is_plane() ? 0 : h * move(random)});
    cloud.volumes.push_back(lattice.volume(slot) * (1 + move(random)));
  }
  return Particles(cloud, lattice.density());
}

/// The same body with neighbour lists in place of the stencil: same law, corrections made anew from the lists.
inline Body listed(const Body& body, const std::optional<BreakingRule>& rule_of_breaking, FamilyRule rule = FamilyRule::hu_ha_bobaru) {
  Particles particles = as_cloud(body.particles, 0);
  Family family(find_bonds(rule, body.family.horizon(), particles), particles);
  Breaking breaking;
  if (rule_of_breaking) breaking = Breaking(*rule_of_breaking, {}, family, particles);
  const auto force = [&]() -> InternalForce::Kind {
    if (const OrdinaryStateForce* ordinary = body.internal.ordinary_state())
      return OrdinaryStateForce(ordinary->law(), breaking, CorrectionFactors(ordinary->correction().kind(), basis_of(ordinary->law()), family, particles),
                                family, particles);
    const Correspondence& law = *body.internal.correspondence();
    if (particles.is_plane()) return CorrespondenceForce<2>(law, breaking, family, particles);
    return CorrespondenceForce<3>(law, breaking, family, particles);
  };
  InternalForce internal(force(), particles);
  return {body.name, std::move(particles), std::move(family), std::move(internal)};
}

inline Body body(const BodyOptions& options = {}) {
  const BodySetup setup = body_setup(options);
  if (options.points == Points::lattice) return make_body(setup);
  if (options.points == Points::shaken) return make_body(setup, as_cloud(make_particles(setup), 0.2));
  Body lattice = make_body(setup);
  return listed(lattice, lattice.internal.breaking().rule(), options.family);
}

/// Moves every particle by up to `amount` [m] in each direction, in the plane where the body is plane.
inline void shake(Body& body, double amount, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> move(-amount, amount);
  for (const std::uint32_t slot : body.particles.slot_of()) {
    Vec3d moved{move(random), move(random), move(random)};
    if (body.particles.is_plane()) moved.z = 0;
    body.particles.position.set(slot, body.particles.position.at(slot) + moved);
  }
}

/// Gives every particle a velocity of up to `amount` [m/s] in each direction, in the plane where the body is plane.
inline void set_random_velocities(Body& body, double amount, unsigned seed = 5) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> speed(-amount, amount);
  for (const std::uint32_t slot : body.particles.slot_of())
    body.particles.velocity.set(slot, {speed(random), speed(random), body.particles.is_plane() ? 0 : speed(random)});
}

/// Maps every particle from its reference position.
template <class Map>
void deform(Body& body, const Map& map) {
  for (const std::uint32_t slot : body.particles.slot_of()) body.particles.position.set(slot, map(body.particles.reference(slot)));
}

/// A number from 0 to 1 that both ends of a bond agree upon: to cut bonds at random.
inline double drawn(std::size_t i, std::size_t j) {
  std::mt19937_64 random(1000003 * std::min(i, j) + std::max(i, j));
  random.discard(4);
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

struct NamedOptions {
  std::string name;
  BodyOptions options;
};

/// Every material in every dimension on every kind of points: what the property tests run over.
inline std::vector<NamedOptions> every_body(const Vec3d& size = {0.010, 0.007, 0.006}) {
  std::vector<NamedOptions> all;
  const std::pair<const char*, Points> points[] = {{"lattice", Points::lattice}, {"listed", Points::listed}, {"shaken cloud", Points::shaken}};
  const std::pair<const char*, Plane> planes[] = {{"space", Plane::none}, {"plane stress", Plane::stress}, {"plane strain", Plane::strain}};
  for (const auto& [where, plane] : planes)
    for (const auto& [kind, on] : points) {
      const auto add = [&, place = std::string(where), grid = std::string(kind), on = on, plane = plane](const std::string& model, BodyOptions options) {
        options.size = size, options.plane = plane, options.points = on;
        all.push_back({model + ", " + place + ", " + grid, options});
      };
      for (const double nu : {0.1, 0.25, 0.4})
        for (const SurfaceCorrection correction : {SurfaceCorrection::none, SurfaceCorrection::energy, SurfaceCorrection::volume})
          add("ordinary state", {.poissons_ratio = nu, .correction = correction});
      for (const Influence influence : {Influence::constant, Influence::inverse, Influence::inverse_square, Influence::parabolic, Influence::gaussian})
        add("linear solid", {.poissons_ratio = 0.3, .model = Model::linear_solid, .influence = influence});
      add("bond-based", {.model = Model::bond_based});
      for (const StressLaw law : {StressLaw::hencky, StressLaw::st_venant_kirchhoff})
        for (const Stabilisation stabilisation : {Stabilisation::bond_level, Stabilisation::wan, Stabilisation::silling})
          add(std::string(law == StressLaw::hencky ? "correspondence, hencky" : "correspondence, st-venant-kirchhoff") +
                  (stabilisation == Stabilisation::bond_level ? ", bond-level" : ""),
              {.poissons_ratio = 0.3, .model = Model::correspondence, .law = law, .stabilisation = stabilisation});
    }
  return all;
}

/// Number of particles that impactors have crushed wholly.
inline std::size_t count_crushed(const Particles& particles) {
  return static_cast<std::size_t>(std::ranges::count_if(particles.slot_of(), [&](std::uint32_t slot) { return particles.crushed.is_crushed(slot); }));
}

}  // namespace fixtures
