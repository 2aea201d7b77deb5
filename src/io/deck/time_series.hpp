/// Motion against time from a CSV file:
///
///   time [s], velocity [m/s]
///   0, 0
///   0.5, 1.2
///
/// The first line names both columns with their units, which are converted to SI: velocity or displacement, of a translation or a rotation.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace perimpact::deck {

struct TimeSeries {
  std::vector<double> times;     ///< [s], increasing
  std::vector<double> values;    ///< [m/s] or [m]; [rad/s] or [rad]
  bool is_displacement = false;  ///< or velocity
};

/// Throws InputError: at `place` (of the deck) if the file does not exist, else at "file:line" of the invalid row.
TimeSeries read_time_series(const std::filesystem::path& file, bool of_rotation, const std::string& place);

}  // namespace perimpact::deck
