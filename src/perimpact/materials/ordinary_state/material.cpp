#include "perimpact/materials/ordinary_state/material.hpp"

#include <utility>

namespace perimpact {

namespace {

Plasticity plasticity_of(const PlasticitySetup& setup) {
  const auto surface = setup.surface.as<YieldSurface>();
  const YieldEllipse ellipse = setup.compressive_strength ? YieldEllipse::of_strength(surface, *setup.compressive_strength) : YieldEllipse::published(surface);
  Plasticity plasticity{ellipse, {setup.failure_strain, setup.failure_width, setup.failure_pressure}};
  if (setup.friction_angle) plasticity.residual = residual_of_friction_angle(*setup.friction_angle);
  return plasticity;
}

}  // namespace

OrdinaryStateMaterial::Force OrdinaryStateMaterial::make_force(const ElasticSetup& setup, const MaterialParts& parts) {
  CorrectionFactors correction(parts.correction, basis_of(parts.linear_law), parts.family, parts.particles);
  if (setup.plasticity)
    return PlasticForce(parts.linear_law, plasticity_of(*setup.plasticity), parts.rule, parts.strength, std::move(correction), parts.family, parts.particles);
  return OrdinaryStateForce(parts.linear_law, parts.breaking(), std::move(correction), parts.family, parts.particles);
}

MaterialMemory OrdinaryStateMaterial::memory(const ElasticSetup& setup, const MemoryQuestion& question, bool has_dilatation) {
  constexpr double number = sizeof(double), vector = sizeof(Vec3d);
  const ArrayLengths& length = question.lengths;
  const double n = length.slots;
  const bool by_energy = question.correction == CorrectionKind::energy,
             by_volume = question.correction == CorrectionKind::volume || question.correction == CorrectionKind::family;
  double arrays = (by_energy ? 2 * vector : by_volume ? number : 0) * length.with_slack + n / 2 + (has_dilatation ? number * length.with_slack : 0);
  arrays += length.is_list() ? (has_dilatation ? 2 : 1) * number * length.entries : by_energy ? number * length.tables : 0;
  if (setup.plasticity)  // plastic_force.hpp: three tensors and five numbers a slot, directions of the entries of a list
    arrays += 23 * number * length.with_slack + n + n / 4 + (length.is_list() ? (has_dilatation ? 3 : 4) * number * length.entries : 0);
  // each sweep of the energy correction makes new factors beside the old ones
  return {arrays, by_energy ? 2 * vector * length.with_slack + 3 * n : 0};
}

}  // namespace perimpact
