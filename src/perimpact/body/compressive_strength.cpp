#include "perimpact/body/compressive_strength.hpp"

#include <algorithm>
#include <limits>

namespace perimpact {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Stretch of the bonds in the outermost layers of a specimen over its compression: bars of ten particles and more across, ν = 0.2 to 0.35, with the energy
/// correction (table in docs/theory/damage.md, which this line meets within 0.002).
double face_stretch(double poissons_ratio) { return 0.37 + 1.74 * (poissons_ratio - 0.25); }

bool has_measured_faces(const BodySetup& setup) {
  const bool is_ordinary = std::holds_alternative<BondBasedSetup>(setup.material) || std::holds_alternative<OrdinaryStateSetup>(setup.material);
  const auto correction = setup.surface_correction.as<SurfaceCorrection>();
  return is_ordinary && setup.spacing && !setup.is_plane() && (correction == SurfaceCorrection::automatic || correction == SurfaceCorrection::energy);
}

/// E s_c/(stretch - α), the stretch of bonds across the load over the compression.
double splitting(double tensile_strength, double stretch, double hardening) { return stretch > hardening ? tensile_strength / (stretch - hardening) : never; }

/// Of a specimen that yields: the limit of its bonds rises by 0.25 σ/E, ¾ p/E in uniaxial compression; ν = 1/4, as in that rule.
double faces_that_yield(const PlasticForce& plastic, const std::optional<FailureCriterion>& failure) {
  const double strength = plastic.plasticity().ellipse.compressive_strength();
  return failure ? std::min(strength, splitting(failure->stretch * plastic.law().elastic().youngs_modulus, face_stretch(0.25), 0.25)) : strength;
}

}  // namespace

std::optional<CompressiveStrength> compressive_strength(const BodySetup& setup, const Body& body) {
  if (const PlasticForce* plastic = body.internal.plastic())
    return CompressiveStrength{plastic->plasticity().ellipse.compressive_strength(), faces_that_yield(*plastic, body.failure)};
  if (!body.failure) return {};
  const BreakingRule rule = breaking_rule(setup.failure, *body.failure);
  const IsotropicElastic elastic = elastic_of(setup);
  const double modulus = elastic.youngs_modulus * body.bending.value_or(1);
  const double crushing = rule.compression ? modulus * *rule.compression : never;
  const auto strength = [&](double stretch) { return std::min(crushing, splitting(modulus * rule.stretch, stretch, rule.hardening)); };
  return CompressiveStrength{strength(elastic.poissons_ratio),
                             has_measured_faces(setup) ? std::optional(strength(face_stretch(elastic.poissons_ratio))) : std::nullopt};
}

}  // namespace perimpact
