/// One step in time, as everything that depends on time needs it.
#pragma once

namespace fccda {

/// From t0 to t1 = t0 + dt. All three are kept: consecutive steps share their ends to the bit, and t1 - t0 rounds where dt does not.
struct Step {
  double t0 = 0, t1 = 0;  ///< [s]
  double dt = 0;          ///< [s]
};

}  // namespace fccda
