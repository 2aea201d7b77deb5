/// Small bodies of ice that yields, for tests: both materials, with every surface correction, on every kind of points.
#pragma once

#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "perimpact/bodies.hpp"

namespace fixtures {

inline constexpr double modulus = 1.8e9, compressive = 2.3e6, spacing = 0.1;

struct IceOptions {
  Vec3d size{0.8, 0.7, 0.6};
  double poissons_ratio = 0.25;  // that of a bond-based body; others are ordinary state-based
  SurfaceCorrection correction = SurfaceCorrection::automatic;
  Points points = Points::lattice;
  std::optional<double> critical_stretch = {};
  bool is_plastic = true;
  double failure_pressure = 0.75;
  std::optional<double> friction_angle = {};
  double failure_strain = 0.01, failure_width = 1;
};

inline BodySetup ice_setup(const IceOptions& options) {
  BodySetup setup = body_setup({.size = options.size, .spacing = spacing, .correction = options.correction});
  ElasticSetup elastic{modulus, options.poissons_ratio, 900, options.critical_stretch};
  if (options.is_plastic)
    elastic.plasticity = PlasticitySetup{.compressive_strength = compressive,
                                         .failure_strain = options.failure_strain,
                                         .failure_width = options.failure_width,
                                         .failure_pressure = options.failure_pressure,
                                         .friction_angle = options.friction_angle};
  if (options.poissons_ratio == 0.25)
    setup.material = BondBasedSetup{elastic};
  else
    setup.material = OrdinaryStateSetup{elastic};
  return setup;
}

inline Body ice(const IceOptions& options = {}) {
  const BodySetup setup = ice_setup(options);
  if (options.points == Points::lattice) return make_body(setup);
  return make_body(setup, as_cloud(make_particles(setup), options.points == Points::shaken ? 0.2 : 0));
}

struct NamedIce {
  std::string name;
  IceOptions options;
};

/// On every kind of points, of both materials, with every surface correction.
inline std::vector<NamedIce> every_ice(const Vec3d& size) {
  std::vector<NamedIce> all;
  const std::pair<const char*, Points> points[] = {{"lattice", Points::lattice}, {"listed", Points::listed}, {"shaken cloud", Points::shaken}};
  const std::pair<const char*, SurfaceCorrection> corrections[] = {
      {"none", SurfaceCorrection::none}, {"energy", SurfaceCorrection::energy}, {"volume", SurfaceCorrection::volume}};
  for (const auto& [kind, on] : points)
    for (const auto& [word, correction] : corrections)
      for (const double nu : {0.25, 0.33, 0.15})
        all.push_back({std::string(kind) + ", correction " + word + ", nu " + std::to_string(nu),
                       {.size = size, .poissons_ratio = nu, .correction = correction, .points = on}});
  return all;
}

/// Plastic strains of up to `amount`, different in every third particle and none in the others.
inline std::vector<SymmetricTensor> draw_strains(Body& body, double amount, unsigned seed = 3) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> draw(-amount, amount);
  std::vector<SymmetricTensor> all(body.particles.size(), SymmetricTensor{});
  for (std::size_t n = 0; n < all.size(); n += 3) {
    for (double& component : all[n]) component = draw(random);
    body.internal.plastic()->set_plastic_strain(body.particles.slot_of()[n], all[n], body.family);
  }
  return all;
}

/// x = X + ε X
inline void strain_uniformly(Body& body, const SymmetricTensor& e) {
  deform(body, [&](const Vec3d& X) {
    return X + Vec3d{e[0] * X.x + e[3] * X.y + e[5] * X.z, e[3] * X.x + e[1] * X.y + e[4] * X.z, e[5] * X.x + e[4] * X.y + e[2] * X.z};
  });
}

}  // namespace fixtures
