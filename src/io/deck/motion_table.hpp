/// Tables against time that a deck gives as a file.
#pragma once

#include <filesystem>
#include <string>

#include "perimpact/deck_model/motion_table.hpp"
#include "perimpact/deck_model/places.hpp"

namespace perimpact::deck {

/// Fills the lists from the file, if there is one; a relative path starts at `folder`.
void read_table(MotionTable& table, bool of_rotation, const std::string& path, const std::filesystem::path& folder, const Places& places);

}  // namespace perimpact::deck
