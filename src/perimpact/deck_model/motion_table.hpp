/// Motion tabulated against time in the deck model.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "perimpact/deck_model/places.hpp"

namespace perimpact {

inline constexpr std::string_view table_times_sentence = "Times of the points, increasing; values between them are interpolated linearly.";
inline constexpr std::string_view table_file_sentence =
    "In place of the lists: a CSV file with two columns and a header line with units, \"time [s], velocity [m/s]\" or \"time [s], displacement [m]\"; a "
    "relative path starts at the deck's folder.";

/// Motion against time: `times` with either `velocities` or `displacements`. If the deck names a file instead, the lists are filled from it
/// when the deck is read.
struct MotionTable {
  std::vector<double> times;                      ///< [s]
  std::vector<double> velocities, displacements;  ///< [m/s] and [m], or [rad/s] and [rad]
  std::string file;
};

/// What the values of a table depend on, as named in decks.
struct TableArgument {
  std::string_view name, list, unit;
};
inline constexpr TableArgument time_argument{"time", "times", "s"}, speed_argument{"speed", "speeds", "m/s"};

// Each throws SetupError with the key unless the condition in its name is met.
void check_increasing(const std::vector<double>& arguments, const std::string& key, const TableArgument& argument = time_argument);
void check_as_many(std::size_t values, std::size_t arguments, std::string_view name, const std::string& key, const TableArgument& argument = time_argument);

/// Requires times with one of the lists, or a file, but not both.
void check_table(const MotionTable& table, const std::string& key, const Places& places);

}  // namespace perimpact
