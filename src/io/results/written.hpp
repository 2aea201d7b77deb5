/// Amount of output that a run has written. A checkpoint stores it, so that a restart continues the same files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/state.hpp"
#include "io/results/panel_frames.hpp"

namespace perimpact {

struct Written {
  std::uint64_t history = 0;                     ///< [byte] of history.csv
  std::vector<std::uint64_t> pressure_area;      ///< [byte] of each impactor's process curve; 0: none yet
  std::vector<std::uint64_t> fragments;          ///< [byte] of each body's fragment table; 0: none
  std::vector<PanelFrames> panel_frames;         ///< per impactor
  std::vector<std::vector<double>> frame_times;  ///< [s] per series, bodies before impactors
  std::int64_t last_frame_step = -1;             ///< step of the previous frame; -1: none
  std::vector<std::int64_t> resumed_at;          ///< steps of the restarts

  /// For a run with these numbers of bodies and impactors.
  Written(std::size_t bodies, std::size_t impactors) : pressure_area(impactors), fragments(bodies), panel_frames(impactors), frame_times(bodies + impactors) {}

  /// State visitor (base/state.hpp).
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit("history", history);
    visit("pressure_area", std::span<std::uint64_t>(pressure_area));
    visit("fragments", std::span<std::uint64_t>(fragments));
    for (std::size_t i = 0; i < panel_frames.size(); ++i) panel_frames[i].visit_state(fccda::under("panel_pictures." + std::to_string(i), visit));
    for (std::size_t s = 0; s < frame_times.size(); ++s) visit("frame_times." + std::to_string(s), frame_times[s]);
    visit("last_frame_step", last_frame_step);
    visit("resumed_at", resumed_at);
  }
};

}  // namespace perimpact
