/// Smaller panels where they are wanted, on the surface as it is: every new vertex halves an edge, so area, volume and shape stay.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "mesh/panels.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// Which panels become how small. Box, part and angle narrow one another; with none of them it is all panels.
struct Refinement {
  std::string name = "refinement";            ///< how messages call it
  double edge_length = 0;                     ///< [m] longest edge wanted
  std::optional<Box> box{};                   ///< [m] only panels that reach into it, in the frame of the surface
  std::optional<std::string> surface_part{};  ///< only panels of that part
  std::optional<double> angle{};              ///< [rad] only where the surface curves: panels turn by at most so much, and are not smaller than `panel` for it;
                                              ///< at creases they are `panel` long (curvature.hpp)
};

/// The triangles of the surface, halved across their longest edges until each is as small as wanted; of several refinements the
/// smallest size counts. Neighbours are halved along, so that no vertex hangs on an edge, and no angle becomes smaller than half the
/// smallest of the triangle it lies in (bisection.hpp). Parts keep their names. Panels are wound outward: where the surface was open, normals
/// point to its outside. Throws InputError where a part is none, a box empty, or more than `most` panels would be added.
Panels refine(const Surface& surface, std::span<const Refinement> refinements, double most = 3e7);

}  // namespace fccda
