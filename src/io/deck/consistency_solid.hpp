/// Consistency of a body's solids and point clouds.
#pragma once

#include <filesystem>

#include "perimpact/deck_model/places.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

/// Fills in the full paths of the body's files and the particles of its points. Throws InputError at the position of the contradicting value.
void make_shape_consistent(BodySetup& body, const std::filesystem::path& folder, const Places& places);

}  // namespace perimpact::deck
