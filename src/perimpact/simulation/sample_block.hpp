/// A small block of a body's material, from which a property of a large body is estimated before it exists.
#pragma once

#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

/// The body as a box of so many cells along each axis, without holes, cracks, boundary conditions and named sets. It must be on a lattice.
inline BodySetup sample_block(const BodySetup& body, int cells) {
  BodySetup block = body;
  const double size = cells * body.spacing.value();
  block.shape = BoxSolid{.size = {size, size, size}};
  block.position = block.rotate = {};
  block.add = block.holes = block.particle_sets = {};
  block.cracks = {};
  block.boundary_conditions = {};
  block.bending_calibration.index = 0;
  if (block.failure) block.failure->no_fail = {};
  return block;
}

}  // namespace perimpact
