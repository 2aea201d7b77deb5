/// Consistency of a body's boundary conditions, also with time.relax.
#pragma once

#include <filesystem>

#include "perimpact/deck_model/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Fills in prescribed motions from files. Relative paths start at `folder`. Throws InputError at the position of the contradicting value.
void make_boundary_conditions_consistent(BodySetup& body, bool is_quasi_static, const std::filesystem::path& folder, const Places& places);

/// Refuses what time.relax does not support.
void check_relaxation(const Setup& setup, const Places& places);

}  // namespace perimpact::deck
