#include "perimpact/materials/correspondence/material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

namespace {

template <std::size_t D>
CorrespondenceForce<D> require_full_rank(CorrespondenceForce<D> force, const MaterialParts& parts) {
  const auto slots = parts.particles.slot_of();
  const bool any = std::any_of(slots.begin(), slots.end(), [&](std::size_t slot) { return force.remaining(slot) > 0; });
  if (parts.particles.share().ranks().any(any)) return force;
  throw SetupError("bodies." + parts.body.name + ".material.model",
                   fmt::format("body {} is too thin for the model correspondence: its particles have neighbours in one {} only, which define no deformation "
                               "gradient; use a smaller spacing{}.",
                               parts.body.name, D == 3 ? "plane" : "line", D == 3 ? ", or plane: stress" : ""));
}

}  // namespace

Material<CorrespondenceSetup>::Force Material<CorrespondenceSetup>::make_force(const CorrespondenceSetup& setup, const MaterialParts& parts) {
  const CorrespondenceOptions options{setup.law.as<StressLaw>(), setup.stabilisation.as<Stabilisation>(), setup.stabilisation_factor,
                                      setup.influence.as<Influence>()};
  const double horizon = parts.body.horizon_ratio * parts.particles.spacing();
  const Correspondence law(parts.elastic, options, horizon, parts.thickness());
  if (parts.particles.is_plane()) return require_full_rank(CorrespondenceForce<2>(law, parts.breaking(), parts.family, parts.particles), parts);
  return require_full_rank(CorrespondenceForce<3>(law, parts.breaking(), parts.family, parts.particles), parts);
}

MaterialMemory Material<CorrespondenceSetup>::memory(const CorrespondenceSetup& setup, const MemoryQuestion& question) {
  constexpr double number = sizeof(double), vector = sizeof(Vec3d);
  const ArrayLengths& length = question.lengths;
  const int dimension = question.body.is_plane() ? 2 : 3, square = dimension * dimension;
  const bool is_bond_level = setup.stabilisation.as<Stabilisation>() == Stabilisation::bond_level;
  const int bond_level = is_bond_level ? square * (setup.may_fail() ? 3 : 2) : 0;
  const double of_slot = dimension * (dimension + 1) / 2 + 3 + square + 1 + bond_level;
  return {breaking_memory(question.body, length) + number * of_slot * length.with_slack + length.rows +
          (length.is_list() ? vector * length.slots + number * length.entries : 0)};
}

}  // namespace perimpact
