/// What a run leaves behind, written as it goes: history.json (what the columns of history.csv are) at once, history.csv row by
/// row, frames and lines when their time has come, run.json at the end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/output/csv.hpp"
#include "io/output/pvd.hpp"
#include "io/output/results_folder.hpp"
#include "io/results/fragment_tables.hpp"
#include "io/results/lines.hpp"
#include "io/results/panel_frames.hpp"
#include "io/results/pressure_area.hpp"
#include "io/results/written.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

/// How a run ended, for run.json.
enum class Outcome { finished, interrupted, failed };

class ResultsWriter {
 public:
  /// Prepares the folder (InputError where that fails) and writes what is known at t = 0. Throws what lines_of throws, before any
  /// file of an earlier run is gone, and RunError where a file cannot be written.
  ResultsWriter(const Simulation& simulation, const std::filesystem::path& folder);

  /// Goes on where another left off, which had written so much of a run that is now at this step: what was written later is taken back.
  /// Throws InputError where the files hold less than that, before anything is changed.
  ResultsWriter(const Simulation& simulation, const std::filesystem::path& folder, Written written);

  /// Call after every step.
  void after_step(const Simulation& simulation);

  /// Writes a last frame where none is of this time, and run.json. `failure`: the sentence of the error, if one ended the run.
  void finish(Simulation& simulation, Outcome outcome, const std::string& failure, double wall_seconds);

  /// What was written so far. It has reached the disk when this returns.
  Written written();

  const std::vector<std::int64_t>& resumed_at() const { return resumed_at_; }  ///< steps

 private:
  void write_frame(const Simulation& simulation);
  void write_line(const Simulation& simulation, const Line& line) const;
  long step_of_frame(int frame, const Clock& clock) const;

  std::vector<Line> lines_;
  output::ResultsFolder folder_;
  output::CsvWriter history_;
  std::vector<output::Series> body_series_, impactor_series_;
  std::vector<PanelFrames> panel_frames_;       // of each impactor
  std::vector<PressureArea> pressure_area_;     // of each impactor
  std::vector<FragmentTable> fragment_tables_;  // of each body
  int frames_wanted_;
  int next_frame_ = 0;
  long last_frame_step_ = -1;
  std::vector<std::int64_t> resumed_at_;  // steps
};

/// The particles of a body as ParaView shows them: displacement, velocity, damage and, where they are known, its fragments.
void write_particles(const std::filesystem::path& path, const Body& body, std::optional<double> time, const Fragments* fragments = nullptr);

}  // namespace perimpact
