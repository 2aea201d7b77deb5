/// Small bodies for tests, and the sums over their bonds written as plainly as possible.
#pragma once

#include <random>

#include "perimpact/simulation/body.hpp"

namespace perimpact::fixtures {

struct BodyOptions {
  Vec3d size{0.02, 0.015, 0.009};
  double spacing = 0.001;
  double poissons_ratio = 0.25;
  SurfaceCorrection correction = SurfaceCorrection::energy;
  FamilyRule family = FamilyRule::hu_ha_bobaru;
  Normalisation normalisation = Normalisation::lattice;
  std::optional<double> critical_stretch = {};
};

inline constexpr double youngs_modulus = 191e9, density = 8000;

inline BodySetup body_setup(const BodyOptions& options = {}) {
  BodySetup setup;
  setup.name = "body";
  setup.shape = BoxSolid{options.size};
  setup.spacing = options.spacing;
  setup.family.index = static_cast<int>(options.family);
  setup.normalisation.index = static_cast<int>(options.normalisation);
  setup.surface_correction.index = static_cast<int>(options.correction);
  setup.material = OrdinaryStateSetup{youngs_modulus, options.poissons_ratio, density, options.critical_stretch};
  return setup;
}

inline Body body(const BodyOptions& options = {}) { return make_body(body_setup(options)); }

/// Moves every particle by up to `amount` [m] in each direction.
inline void shake(Body& body, double amount, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> move(-amount, amount);
  for (const std::uint32_t slot : body.particles.slot_of()) body.particles.position.set(slot, body.particles.position.at(slot) + Vec3d{move(random), move(random), move(random)});
}

/// Maps every particle from its reference position.
template <class Map>
void deform(Body& body, const Map& map) {
  for (const std::uint32_t slot : body.particles.slot_of()) body.particles.position.set(slot, map(body.particles.reference(slot)));
}

}  // namespace perimpact::fixtures
