/// Warnings about the step that a deforming surface has begun: motions that DeformingSurface::move() accepts, but that few programs intend.
#pragma once

#include <string>
#include <vector>

#include "fccda/deforming/deforming_surface.hpp"

namespace fccda {

/// One sentence each, empty if there is nothing to report:
///   panels that move farther than their longest edge in the step
///   panels whose normal turns by more than 90° in it
///   panels that pass through others at its end
/// The last of them takes longer than the move itself: for a check now and then, or of a step with a surprising result.
std::vector<std::string> step_warnings(const DeformingSurface& surface);

}  // namespace fccda
