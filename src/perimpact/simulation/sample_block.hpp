/// A small block of a body's material, from which a property of a large body is estimated before it exists.
#pragma once

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/discretise.hpp"

namespace perimpact {

/// The body as a box of so many particles along each axis, or two of a plane body, without holes, cracks, boundary conditions and named sets: on its lattice,
/// or as a cloud of equal particles at the mean spacing of its points. `discretisation`: of the body.
BodySetup sample_block(const BodySetup& body, const Discretisation& discretisation, int particles);

}  // namespace perimpact
