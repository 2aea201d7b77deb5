/// The order of points along a space-filling curve, so that neighbours in space are near in memory (Morton, A computer oriented geodetic data base
/// and a new technique in file sequencing, IBM 1966).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

/// Numbers of the points in the order of the curve; points in one of its 2^63 cells in rising order of their numbers.
std::vector<std::uint32_t> space_order(std::span<const Vec3d> points);

}  // namespace perimpact
