/// Tables against time, wherever a deck has them: lists that fit one another, or a file in their place.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/deck/places.hpp"
#include "perimpact/deck_model/motion_table.hpp"

namespace perimpact::deck {

/// Each refuses at `place` what the name says is not so.
void check_increasing(const std::vector<double>& times, const std::string& place);
void check_as_many(std::size_t values, std::size_t times, std::string_view name, const std::string& place);

/// One of the lists, or a file, and nothing twice.
void check_table(const MotionTable& table, const std::string& path, const Places& places);

/// Puts the numbers of the file into the lists, where there is one; a relative path starts at `folder`.
void read_table(MotionTable& table, bool of_rotation, const std::string& path, const std::filesystem::path& folder, const Places& places);

}  // namespace perimpact::deck
