/// Time of a run, counted in whole steps so that it never drifts.
#pragma once

namespace perimpact {

struct Clock {
  double dt;        ///< [s]
  long steps;       ///< of the whole run
  long step = 0;    ///< done

  double time() const { return static_cast<double>(step) * dt; }  ///< [s]
  bool is_finished() const { return step >= steps; }
};

}  // namespace perimpact
