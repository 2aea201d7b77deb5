/// Measures of a surface that tell whether it suits a lattice of particles and a time step: how large its panels are, how far they lie
/// off the curve they stand for, how thick what they enclose is.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/panel_faces.hpp"
#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// [m] the edge of a square (of a triangle: half a square) of the median panel's area.
double median_panel_size(const Surface& surface, const PanelFaces& faces);

struct Facet {
  double sagitta = 0;  ///< [m]
  double angle = 0;    ///< [rad] between the normals of the two triangles
  int panel = -1;
  Vec3d place{};  ///< [m] middle of their edge, in the frame of the surface
};

/// The facet that lies furthest off the smooth surface it stands for: w θ/8 at an edge that bends by θ between triangles that are w high
/// above it (mean of the two), the sagitta of an arc of the length w that turns by θ. Edges that bend by 60° or more are taken as meant.
Facet coarsest_facet(const Surface& surface);

struct Thickness {
  double thickness;  ///< [m] from the middle of a triangle straight inward to where the surface is left again
  int panel;
  Vec3d place;  ///< [m] that middle, in the frame of the surface
};

/// Of triangles evenly taken from all, at most `most`. None of an open surface.
std::vector<Thickness> thicknesses(const Surface& surface, const Bvh& bvh, std::size_t most);

}  // namespace fccda
