/// What contact did to the panels of an impactor, as the cell arrays of its pictures:
///
///   contact_pressure [Pa]   normal, mean over the time since the picture before
///   peak_pressure [Pa]      the largest mean over one load interval so far (docs/guide/results.md)
///   contact_impulse [N s]   since the start, along the axes of the world
#pragma once

#include <filesystem>
#include <vector>

#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

class PanelFrames {
 public:
  /// Writes the impactor where it is at that time [s]. Call it in the order of time. An impactor whose detector names no panels
  /// (analytic) is written without arrays.
  void write(const std::filesystem::path& path, const Impactor& impactor, double time);

  /// As base/state.hpp says.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit("normal_impulse", normal_impulse_);
    visit("time", time_);
  }

 private:
  std::vector<double> normal_impulse_;  // [N s] of each panel at the picture before
  double time_ = 0;                     // [s] of the picture before
};

/// The panels of an impactor where it is now, without arrays.
void write_impactor(const std::filesystem::path& path, const Impactor& impactor);

}  // namespace perimpact
