/// Measures of a surface's suitability for a particle spacing and a time step: panel size, deviation of facets from the curved shape, and
/// wall thickness.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/panel_faces.hpp"
#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// [m] Edge of a square (of a triangle: half a square) with the median panel area.
double median_panel_size(const Surface& surface, const PanelFaces& faces);

struct Facet {
  double sagitta = 0;  ///< [m]
  double angle = 0;    ///< [rad] between the normals of the two triangles
  int panel = -1;
  Vec3d place{};  ///< [m] midpoint of their edge, in the frame of the surface
};

/// The facet with the largest deviation from the smooth surface that it approximates: w θ/8 at an edge with dihedral deviation θ between
/// triangles of height w above it (mean of the two), the sagitta of an arc of length w and angle θ. Edges of 60° or more are regarded as
/// intended.
Facet coarsest_facet(const Surface& surface);

struct Thickness {
  double thickness;  ///< [m] from the centroid of a triangle straight inward to the exit from the surface
  int panel;
  Vec3d place;  ///< [m] that centroid, in the frame of the surface
};

/// Thicknesses at evenly selected triangles, at most `most`. Empty for an open surface.
std::vector<Thickness> thicknesses(const Surface& surface, const Bvh& bvh, std::size_t most);

}  // namespace fccda
