/// A sphere about the origin as a subdivided icosahedron (geodesic sphere).
#pragma once

#include "mesh/panels.hpp"

namespace fccda {

/// Dimensions of a sphere.
struct SphereShape {
  double diameter = 0;     ///< [m]
  double edge_length = 0;  ///< [m] no edge is longer. 0: diameter/20, with a deviation from the sphere of at most 5e-4 of the diameter
};

/// Triangles, oriented outward, with shared vertices on the sphere; symmetric in the three coordinate planes. Each face of the icosahedron
/// (whose twelve corners lie in those planes) is divided into f² triangles and projected onto the sphere. That stretches lengths by at most
/// R/d, with d the distance of the faces from the centre, so f is the smallest number with (edge/d) R/f <= edge_length.
/// Throws InputError if the diameter is not positive and finite, or the number of panels exceeds the limit.
Panels make_sphere(const SphereShape& shape);

}  // namespace fccda
