#include "perimpact/boundary_conditions/prescribed/boundary.hpp"

#include <fmt/format.h>

#include <utility>

namespace perimpact {

namespace {

DisplacementHistory displacement_history_of(const DisplacementSetup& setup, const std::string& key) {
  if (setup.velocity) return {DisplacementHistory::Of::velocity, fccda::PiecewiseLinear(*setup.velocity)};
  if (setup.displacement) return {DisplacementHistory::Of::displacement, fccda::PiecewiseLinear(*setup.displacement)};
  if (!setup.velocities.empty()) return {DisplacementHistory::Of::velocity, BoundarySite::table(key, setup.times, setup.velocities)};
  return {DisplacementHistory::Of::displacement, BoundarySite::table(key, setup.times, setup.displacements)};
}

}  // namespace

PrescribedDisplacement make_boundary(const PrescribedSetup& prescribed, const BoundarySite& site) {
  PrescribedDisplacement::Histories histories;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const auto& course = prescribed.of(axis)) histories[axis] = displacement_history_of(*course, fmt::format("{}.{}", site.key, axis_words[axis]));
  return PrescribedDisplacement(site.slots(prescribed.particle_set), std::move(histories));
}

}  // namespace perimpact
