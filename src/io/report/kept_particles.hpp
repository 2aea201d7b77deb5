/// Which particles stay where a report cannot hold all of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.hpp"

namespace perimpact::report {

/// About `share` of the particles, by number, in their order. Those that are damaged at the end and those on the surface come first, for they are
/// what is seen; the rest, or those alone where they are too many, are thinned evenly. On the surface is where one of the six places a spacing
/// away along the axes is empty, undeformed.
std::vector<std::uint32_t> kept_particles(std::span<const fccda::Vec3d> undeformed, double spacing, const std::vector<bool>& is_damaged, double share);

}  // namespace perimpact::report
