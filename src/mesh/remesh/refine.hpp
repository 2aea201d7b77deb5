/// Local refinement of panels. Every new vertex halves an edge, so area, volume and shape are unchanged.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "mesh/panels.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// Selection of panels and their size. Box, part and angle are combined (intersection); without any of them all panels are refined.
struct Refinement {
  std::string name = "refinement";            ///< its name in messages
  double edge_length = 0;                     ///< [m] longest edge wanted
  std::optional<Box> box{};                   ///< [m] only panels that reach into it, in the frame of the surface
  std::optional<std::string> surface_part{};  ///< only panels of that part
  std::optional<double> angle{};              ///< [rad] only where the surface is curved: panels turn by at most this angle, but are not made smaller than
                                              ///< `edge_length` for it; at creases they have `edge_length` (curvature.hpp)
};

/// The triangles of the surface, bisected across their longest edges until each meets the smallest size of all refinements. Neighbours are
/// halved along with them, so that no hanging vertex arises, and no angle becomes smaller than half the smallest of its original triangle
/// (bisection.hpp). Parts keep their names. Panels are oriented outward: if the surface was open, normals point to its outside. Throws
/// InputError if a part does not exist, a box contains no panels, or more than `most` panels would be added.
Panels refine(const Surface& surface, std::span<const Refinement> refinements, double most = 3e7);

}  // namespace fccda
