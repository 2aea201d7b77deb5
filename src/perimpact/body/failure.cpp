#include "perimpact/body/failure.hpp"

#include <algorithm>
#include <cmath>

#include "perimpact/damage/strength.hpp"
#include "perimpact/materials/ordinary_state/fracture_energy.hpp"

namespace perimpact {

namespace {

/// Number of particle layers in the thinnest direction.
int thinnest_layers(const Particles& particles) {
  const Vec3d size = extent(particles);
  const double thinnest = particles.is_plane() ? std::min(size.x, size.y) : std::min({size.x, size.y, size.z});
  return std::max(2, static_cast<int>(std::lround(thinnest / particles.spacing())));
}

/// k of G₀ = k s_c² [J/m²]: of a crack along a plane of the lattice's cells, or of the continuum.
double fracture_energy_of_unit_stretch(const OrdinaryState& law, const Family& family, const Particles& particles) {
  const double of_dilatation = fracture_energy_of_dilatation(law, family.horizon());
  if (!family.stencil()) return of_dilatation + fracture_energy_of_bonds(law, family.horizon(), particles.thickness().value_or(1));
  double of_bonds = 0;
  for (const StencilBond& bond : family.stencil()->bonds())
    if (bond.di > 0) of_bonds += bond.di * particles.spacing() * 2 * law.b() * law.weights(bond.length).stretch * bond.volume;
  return of_dilatation + of_bonds;
}

}  // namespace

std::optional<FailureCriterion> failure_criterion(const BodySetup& setup, const OrdinaryState& law, const Family& family, const Particles& particles) {
  const ElasticSetup& material = setup.elastic();
  if (!material.critical_stretch && !material.fracture_energy && !material.flexural_strength) return {};
  const int layers = material.layers.value_or(thinnest_layers(particles));
  const double k = fracture_energy_of_unit_stretch(law, family, particles), modulus = material.youngs_modulus.value();
  double stretch;
  if (material.critical_stretch)
    stretch = *material.critical_stretch;
  else if (material.fracture_energy)
    stretch = std::sqrt(*material.fracture_energy / k);
  else
    stretch = stretch_of_flexural_strength(*material.flexural_strength, modulus, layers);
  return FailureCriterion{stretch, k * stretch * stretch, flexural_strength_of_stretch(stretch, modulus, layers), layers};
}

BreakingRule breaking_rule(const std::optional<FailureSetup>& setup, const FailureCriterion& criterion) {
  if (!setup) return {criterion.stretch, {}, 0};
  switch (setup->compression.as<CompressionFailure>()) {
    case CompressionFailure::symmetric:
      return {criterion.stretch, criterion.stretch, 0};
    case CompressionFailure::limit:
      return {criterion.stretch, setup->critical_compression, 0};
    case CompressionFailure::none:
      break;
  }
  return {criterion.stretch, {}, setup->compression_hardening};
}

std::vector<double> strength_of(const std::optional<FailureSetup>& setup, const Particles& particles, const std::vector<std::size_t>& never) {
  const std::optional<double> modulus = setup ? setup->weibull_modulus : std::nullopt;
  if (!modulus && !particles.share().ranks().any(!never.empty())) return {};
  std::vector<double> strength(particles.slots(), 1.0);
  if (modulus)
    for (const std::uint32_t slot : particles.slot_of())
      strength[slot] = weibull_factor(*modulus, static_cast<std::uint64_t>(setup->seed.value_or(1)), particles.share().whole_slot(slot));
  for (const std::size_t slot : never) strength[slot] = unbreakable;
  return strength;
}

}  // namespace perimpact
