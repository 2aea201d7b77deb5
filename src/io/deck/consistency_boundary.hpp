/// What the keys of a body's boundaries say together, and with relaxation in place of dynamics.
#pragma once

#include <filesystem>

#include "io/deck/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Fills in the courses that are in files, of which relative paths start at `folder`. Throws InputError at the place of what contradicts
/// something else.
void make_boundary_conditions_consistent(BodySetup& body, const std::filesystem::path& folder, const Places& places);

/// What a set-up that relaxes cannot have.
void check_relaxation(const Setup& setup, const Places& places);

}  // namespace perimpact::deck
