/// Time of a run, counted in whole steps so that it never drifts.
#pragma once

#include "fccda/rigid_body/step.hpp"

namespace perimpact {

struct Clock {
  double dt;      ///< [s]
  long steps;     ///< of the whole run
  long step = 0;  ///< done

  double time() const { return static_cast<double>(step) * dt; }  ///< [s]
  /// The step that led to now; there must have been one.
  fccda::Step latest() const { return {static_cast<double>(step - 1) * dt, time(), dt}; }
  /// The step that comes.
  fccda::Step next() const { return {time(), static_cast<double>(step + 1) * dt, dt}; }
  bool is_finished() const { return step >= steps; }
};

}  // namespace perimpact
