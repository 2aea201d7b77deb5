/// `perimpact statistics`: statistics of forces and channel widths of a run.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace perimpact {

struct StatisticsArguments {
  std::filesystem::path folder;      ///< of the results
  std::string from, to;              ///< times, with a unit or in seconds; empty: the first and last row
  std::vector<std::string> columns;  ///< words of columns_named(); empty: loads
  int windows = 1;                   ///< equal parts of the time
  std::string segment;               ///< of the spectrum, a time; empty: the default

  struct Channel {
    std::string of;        ///< body:axis; empty: no channel
    std::string from, to;  ///< lengths along the axis; empty: the whole body
    double sheet = 0.1;    ///< minimum share of the particles in a fragment of the remaining sheet
  } channel;
};

int statistics_command(const StatisticsArguments& arguments);

}  // namespace perimpact
