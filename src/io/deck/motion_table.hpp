/// Checks of tables against time: lists of equal length, or a file in their place.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "perimpact/deck_model/motion_table.hpp"
#include "perimpact/deck_model/places.hpp"

namespace perimpact::deck {

/// Each throws InputError at `place` unless the condition in its name is met.
void check_increasing(const std::vector<double>& times, const std::string& place);
void check_as_many(std::size_t values, std::size_t times, std::string_view name, const std::string& place);

/// Requires times with one of the lists, or a file, but not both.
void check_table(const MotionTable& table, const std::string& path, const Places& places);

/// Fills the lists from the file, if there is one; a relative path starts at `folder`.
void read_table(MotionTable& table, bool of_rotation, const std::string& path, const std::filesystem::path& folder, const Places& places);

}  // namespace perimpact::deck
