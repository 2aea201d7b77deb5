/// Motion tabulated against time in the deck model.
#pragma once

#include <string>
#include <vector>

namespace perimpact {

/// Motion against time: `times` with either `velocities` or `displacements`. If the deck names a file instead, the lists are filled from it
/// when the deck is read.
struct MotionTable {
  std::vector<double> times;                      ///< [s]
  std::vector<double> velocities, displacements;  ///< [m/s] and [m], or [rad/s] and [rad]
  std::string file;
};

}  // namespace perimpact
