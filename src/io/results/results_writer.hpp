/// Writes the results during a run: history.json (description of the columns of history.csv) at the start, history.csv row by row, frames
/// and lines at their times, run.json at the end. Collective in a run of several ranks, in which the root writes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/frames/series.hpp"
#include "io/output/csv.hpp"
#include "io/output/results_folder.hpp"
#include "io/results/fragment_tables.hpp"
#include "io/results/frame_particles.hpp"
#include "io/results/lines.hpp"
#include "io/results/panel_frames.hpp"
#include "io/results/pressure_area.hpp"
#include "io/results/written.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

/// Outcome of a run, for run.json.
enum class Outcome { finished, interrupted, failed };

class ResultsWriter {
 public:
  /// Prepares the folder (InputError where that fails), removes the files of an earlier run, and writes the results at t = 0. Throws what
  /// lines_of and frame_particles_of throw, before any file is removed, and RunError where a file cannot be written.
  ResultsWriter(const Simulation& simulation, const std::filesystem::path& folder);

  /// Restart: resumes the output at `written` of a run that is now at the step of the checkpoint; later output is removed.
  /// Throws InputError where files are missing or contain less than that, before anything is changed.
  ResultsWriter(const Simulation& simulation, const std::filesystem::path& folder, Written written);

  /// Call after every step.
  void after_step(const Simulation& simulation);

  /// Writes a last frame unless there is one of this time, and run.json. `failure`: the message of the error, if one ended the run.
  void finish(Simulation& simulation, Outcome outcome, const std::string& failure, double wall_seconds);

  /// The amount of output so far, all flushed to disk; on the root.
  Written written();

  const std::vector<std::int64_t>& resumed_at() const { return resumed_at_; }  ///< steps

 private:
  void write_frame(const Simulation& simulation);
  void write_line(const Simulation& simulation, const Line& line) const;
  void skip_frames_until(long step, const Clock& clock);

  /// What is written, by the root of a run of several ranks alone; the others only take part in gathering it.
  struct Files {
    Files(const Simulation& simulation, const std::filesystem::path& path, std::span<const Line> lines);
    Files(const Simulation& simulation, const std::filesystem::path& path, std::span<const Line> lines, Written& written);

    output::ResultsFolder folder;
    output::CsvWriter history;
    std::vector<frames::Series> body_series, impactor_series;
    std::vector<PanelFrames> panel_frames;       // per impactor
    std::vector<PressureArea> pressure_area;     // per impactor
    std::vector<FragmentTable> fragment_tables;  // per body
  };

  std::vector<Line> lines_;
  std::vector<FrameParticles> frame_particles_;  // per body
  std::optional<Files> files_;
  int frames_wanted_;
  int next_frame_ = 0;
  long last_frame_step_ = -1;
  std::vector<std::int64_t> resumed_at_;  // steps
};

/// The step of an output frame, of `frames` in a run of `steps`.
long step_of_frame(int frame, int frames, long steps);

}  // namespace perimpact
