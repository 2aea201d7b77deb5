/// A sphere about the origin as a subdivided icosahedron.
#pragma once

#include "mesh/panels.hpp"

namespace fccda {

struct SphereShape {
  double diameter = 0;     ///< [m]
  double edge_length = 0;  ///< [m] no edge is longer; 0: a twentieth of the diameter, which is off the sphere by 5e-4 of the diameter at most
};

/// Triangles, wound outward, vertices shared and on the sphere; symmetric in the three coordinate planes. Each face of the icosahedron
/// (whose twelve corners lie in those planes) is cut into f² triangles and pushed out to the sphere. That stretches lengths R/d times at
/// most, d being the distance of the faces from the middle, so f is the smallest number with (edge/d) R/f <= panel.
/// Throws InputError where the diameter is not positive and finite, or there would be too many panels.
Panels make_sphere(const SphereShape& shape);

}  // namespace fccda
