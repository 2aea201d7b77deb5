/// Motion tabulated against time in the deck model.
#pragma once

#include <string>
#include <string_view>
#include <vector>

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

}  // namespace perimpact
