/// The lattice that fills the solid of a body, and which of its cells hold a particle.
#pragma once

#include <cstdint>
#include <vector>

#include "perimpact/discretisation/body_solid.hpp"
#include "perimpact/particles/lattice.hpp"

namespace perimpact {

/// True where the body is one box along the axes of the world, perhaps with holes: whole multiples of the spacing then fit it exactly.
bool is_plain_box(const BodySetup& body);

/// How many slots the lattice over the solid has: its cells, rows rounded up. A double, for there may be too many to count.
double slots_of(const BodySetup& body, const BodySolid& solid);

/// A lattice over the bounding box of the solid, centred on it: as many cells along each axis as come nearest to its size, at least one; in a plane body one
/// layer through the position, as thick as the shape. Throws SetupError where there are more than can be numbered.
Lattice lattice_that_fills(const BodySetup& body, const BodySolid& solid);

/// For each slot of the lattice 1 where the centre of the cell is inside the solid (surface_share), else 0.
std::vector<std::uint8_t> cells_inside(const Lattice& lattice, const BodySolid& solid);

}  // namespace perimpact
