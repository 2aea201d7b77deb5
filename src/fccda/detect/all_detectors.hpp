/// The list of detectors. Their common interface:
///
///   detect(points, motion, surface_travel, out)   adds the contacts of a step, in point order
///   detect_again(points, motion, surface_travel, which, out)   the same for points that others moved after that
///   still_inside(points, motion, which)           those of the points that are inside at t1
///   initial_overlap(points, pose)                 points that are inside before the first step
///   nearest_outside(places, pose)                 relocated positions of such points
///   moved(point), forget()                        invalidate cached distances
///   effort()                                      work done so far
///   visit_state(visitor)                          what the next step depends on (base/state.hpp); lists are of numbers of points
///   visit_record(visitor)                         counts: effort(), entries
#pragma once

#include <variant>

#include "fccda/detect/analytic.hpp"
#include "fccda/detect/published.hpp"
#include "fccda/detect/swept.hpp"

namespace fccda {

using Detector = std::variant<Swept, Published, Analytic>;

}  // namespace fccda
