/// A closed circular cylinder about an axis through the origin, centred there.
#pragma once

#include "mesh/panels.hpp"
#include "mesh/shapes/axis.hpp"
#include "mesh/shapes/divisions.hpp"

namespace fccda {

/// Dimensions of a cylinder.
struct CylinderShape {
  double diameter = 0;     ///< [m]
  double height = 0;       ///< [m]
  Axis axis = Axis::z;     ///< of the cylinder
  double edge_length = 0;  ///< [m] longest edge around, along and between the rings of the caps; diagonals are up to √2 longer. 0: diameter/20
  PanelKind panels = PanelKind::triangles;  ///< kind of panels
};

/// Oriented outward, with shared vertices. The lateral vertices lie on the cylinder, in n columns and equal rows. About the axis z, column k is
/// at the angle 2πk/n from +x towards +y (about x from +y towards +z, about y from +z towards +x). n is a multiple of 4, so each of the four
/// directions along the coordinate axes has a column, and coordinates are exact mirror images. The caps are rings of triangles about a
/// vertex on the axis, for quads too. Throws InputError if a length is not positive and finite, or the number of panels exceeds the limit.
Panels make_cylinder(const CylinderShape& shape);

}  // namespace fccda
