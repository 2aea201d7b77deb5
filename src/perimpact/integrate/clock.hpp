/// Simulation time, counted in whole steps to avoid drift.
#pragma once

#include "fccda/rigid_body/step.hpp"

namespace perimpact {

struct Clock {
  double dt;      ///< [s]
  long steps;     ///< of the whole run
  long step = 0;  ///< completed

  double time() const { return static_cast<double>(step) * dt; }  ///< [s]
  /// The previous step; requires step > 0.
  fccda::Step latest() const { return {static_cast<double>(step - 1) * dt, time(), dt}; }
  /// The next step.
  fccda::Step next() const { return {time(), static_cast<double>(step + 1) * dt, dt}; }
  bool is_finished() const { return step >= steps; }
};

}  // namespace perimpact
