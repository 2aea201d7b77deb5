/// Motion against time as a deck gives it.
#pragma once

#include <string>
#include <vector>

namespace perimpact {

/// Motion against time: `times` with either `velocities` or `displacements`. A deck may name a file instead, whose numbers are put here
/// when it is read.
struct MotionTable {
  std::vector<double> times;                      ///< [s]
  std::vector<double> velocities, displacements;  ///< [m/s] and [m], or [rad/s] and [rad]
  std::string file;
};

}  // namespace perimpact
