/// One time step.
#pragma once

namespace fccda {

/// From t0 to t1 = t0 + dt. All three are stored: consecutive steps share their ends exactly, and t1 - t0 is rounded where dt is not.
struct Step {
  double t0 = 0, t1 = 0;  ///< [s]
  double dt = 0;          ///< [s]
};

}  // namespace fccda
