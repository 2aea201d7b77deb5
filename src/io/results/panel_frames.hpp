/// Frames of an impactor: its panels where they are, with contact loads as cell arrays:
///
///   contact_pressure [Pa]   normal, mean over the time since the previous frame
///   peak_pressure [Pa]      the largest mean over one load interval so far (docs/guide/results.md)
///   contact_impulse [N s]   since the start, in the global axes
///
/// and, where its surface deforms, point arrays:
///
///   displacement [m]        from the place of the undeformed surface, in the global axes
///   stress [Pa]             xx, yy, zz, xy, yz, zx in the axes of the surface, if its modes have stresses
///   von_mises_stress [Pa]   of these
#pragma once

#include <filesystem>
#include <vector>

#include "io/frames/series.hpp"
#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

class PanelFrames {
 public:
  /// Passes the impactor at its current position to the sink. Call in the order of `time` [s]. An impactor whose detector does not resolve panels
  /// (analytic) has no arrays.
  void write(const frames::Sink& sink, const Impactor& impactor, double time);

  /// State visitor (base/state.hpp).
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit("normal_impulse", normal_impulse_);
    visit("time", time_);
  }

 private:
  std::vector<double> normal_impulse_;  // [N s] of each panel at the previous frame
  double time_ = 0;                     // [s] of the previous frame
};

/// Writes the panels of an impactor at its current position, without arrays.
void write_impactor(const std::filesystem::path& path, const Impactor& impactor);

}  // namespace perimpact
