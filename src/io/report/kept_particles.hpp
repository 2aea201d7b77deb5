/// Selection of particles for reports of large runs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.hpp"

namespace perimpact::report {

/// Selects about `share` of the particles; returns their numbers in ascending order. Particles damaged at the end and surface particles, which are
/// visible, have priority; the rest, or these where they exceed the share, are thinned evenly. A surface particle lacks at least one of its six
/// neighbours at one spacing along the axes, in the reference configuration.
std::vector<std::uint32_t> kept_particles(std::span<const fccda::Vec3d> undeformed, double spacing, const std::vector<bool>& is_damaged, double share);

}  // namespace perimpact::report
