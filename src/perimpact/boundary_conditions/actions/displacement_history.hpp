/// Displacement history of one direction, given as displacements or as velocities from t = 0 on.
#pragma once

#include <utility>

#include "fccda/rigid_body/piecewise_linear.hpp"

namespace perimpact {

class DisplacementHistory {
 public:
  enum class Of { velocity, displacement };

  DisplacementHistory(Of what, fccda::PiecewiseLinear table) : what_(what), table_(std::move(table)) {}
  static DisplacementHistory rest() { return {Of::displacement, fccda::PiecewiseLinear(0)}; }

  /// [m] from the undeformed position; the integral from t = 0 for a table of velocities.
  double displacement(double time) const {
    if (what_ == Of::displacement) return table_.at(time);
    return time > 0 ? time * table_.mean(0, time) : 0;
  }

  /// [m/s] mean over the interval; for t1 = t0, at that time.
  double velocity(double t0, double t1) const { return what_ == Of::velocity ? table_.mean(t0, t1) : table_.slope(t0, t1); }

 private:
  Of what_;
  fccda::PiecewiseLinear table_;
};

}  // namespace perimpact
