/// Morton order of points along a space-filling curve, for memory locality (Morton, A computer oriented geodetic data base and a new
/// technique in file sequencing, IBM 1966).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

/// Point numbers in the order of the curve; points in the same of its 2^63 cells are in ascending order.
std::vector<std::uint32_t> space_order(std::span<const Vec3d> points);

}  // namespace perimpact
