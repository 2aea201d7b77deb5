/// Consistency of output.frame_fields and output.frame_particles.
#pragma once

#include "perimpact/deck_model/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Throws InputError for unknown or repeated fields, for a selection without a criterion, or beside a moving window, and for boxes without a volume.
void check_frames(const Setup& setup, const Places& places);

}  // namespace perimpact::deck
