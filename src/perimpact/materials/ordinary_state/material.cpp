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
  CorrectionBasis basis = basis_of(parts.linear_law);
  // plasticity needs the dilatation even where it stores no energy, and the linear solid its weights
  if (!parts.linear_law.needs_dilatation() && !setup.plasticity && parts.correction != CorrectionKind::family) basis.dilatation_weight = {};
  CorrectionFactors correction(parts.correction, basis, parts.family, parts.particles);
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
  const double factors = (has_dilatation || setup.plasticity ? 2 : 1) * vector;  // of energy, in each direction
  double arrays = (by_energy ? factors : by_volume ? number : 0) * length.with_slack + n / 2 + (has_dilatation ? number * length.with_slack : 0);
  const double constants = setup.plasticity ? sizeof(PlasticForce::Constants<double>) : sizeof(OrdinaryState::Folded<double>);
  arrays += length.is_list() ? (has_dilatation ? 2 : 1) * number * length.entries : (sizeof(BondFactors) + constants) * length.tables;
  if (!setup.plasticity) arrays += breaking_memory(question.body, length);
  if (setup.plasticity)  // plastic_force.hpp: three tensors and five numbers a slot, marks and dissipation of eights, directions of the entries of a list
    arrays +=
        23 * number * length.with_slack + n + 3 * n / 8 + 2 * number * n / 8 + (length.is_list() ? (has_dilatation ? 3 : 4) * number * length.entries : 0);
  // marks and hashes; the sweeps of the energy correction make new factors of particles near surfaces beside the old ones
  return {arrays, by_energy ? 2 * vector * length.surface * n + 3 * n : by_volume ? 3 * n : 0};
}

}  // namespace perimpact
