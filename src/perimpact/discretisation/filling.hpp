/// Lattice that fills the solid of a body, and its occupied cells.
#pragma once

#include <cstdint>
#include <vector>

#include "perimpact/discretisation/body_solid.hpp"
#include "perimpact/particles/lattice.hpp"

namespace perimpact {

/// True if the body is one axis-aligned box, possibly with holes, so that a whole number of spacings fits exactly.
bool is_plain_box(const BodySetup& body);

/// Number of slots of the lattice: its cells with padded rows; a double, since it may exceed the integer range.
double slots_of(const BodySetup& body, const BodySolid& solid);

/// Lattice over the bounding box of the solid, centred on it, with the nearest number of cells along each axis, at least one. In a plane body
/// one layer through the position, as thick as the shape. Throws SetupError if there are too many cells for 32-bit numbers.
Lattice lattice_that_fills(const BodySetup& body, const BodySolid& solid);

/// For each slot of the lattice, 1 if the centre of the cell is inside the solid (surface_share), else 0.
std::vector<std::uint8_t> cells_inside(const Lattice& lattice, const BodySolid& solid);

/// Number of particles, counted row by row; nothing of the size of the body is allocated. For more than 1e9 slots their number.
double particles_of(const BodySetup& body, const BodySolid& solid);

}  // namespace perimpact
