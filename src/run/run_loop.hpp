/// The loop over the steps of a run, with its results, if any. The command line and Python use it; they only report.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "io/checkpoint/checkpoints.hpp"
#include "io/results/results_writer.hpp"
#include "perimpact/simulation/simulation.hpp"
#include "run/run_folder.hpp"

namespace perimpact {

/// What a front end does during a run. Each returns false to pause it, on all ranks if any does.
struct Watch {
  std::function<bool()> after_step;    ///< its results are written
  std::function<bool()> in_increment;  ///< after each iteration of an increment of relaxation, which may take minutes
};

class RunLoop {
 public:
  explicit RunLoop(Simulation& simulation) : simulation_(simulation) {}

  /// Begins the results in the folder: new ones at step 0, or those of the run to be resumed, whose state is restored. Call before the first step.
  /// The folder must outlive the results. Throws InputError and SetupError as ResultsWriter and Checkpoints do, and RunError.
  void begin_results(const RunFolder& folder);
  bool has_results() const { return results_.has_value(); }
  const std::string& note() const { return note_; }  ///< a sentence about the checkpoint from which the run resumed, or empty

  /// Performs steps to the end of the run, or until the watch pauses it. After the last step the results are complete and closed. On SIGUSR1, if
  /// StopSignals records it, a checkpoint is written. A RunError closes the results as those of a failed run, unless there are several ranks; the sentence then
  /// names the last checkpoint.
  void run(const Watch& watch);

  /// Writes a checkpoint of the current state. Does nothing without results.
  void save();
  /// Writes a checkpoint, run.json and an additional frame of a run that is paused. Does nothing without results.
  void interrupt();

  double seconds() const;  ///< wall-clock time in run() so far

  /// What each rank sends for a step, beside what Simulation::step() sends, where nothing is written.
  static Traffic collectives_in_step(const OutputSetup& setup);

 private:
  void step(const Watch& watch);
  template <class Write>
  void write(const Write& write_files);
  [[noreturn]] void fail(const fccda::RunError& error, bool can_be_resumed);

  Simulation& simulation_;
  std::string resume_;  // how to resume the run
  std::optional<Checkpoints> checkpoints_;
  std::optional<ResultsWriter> results_;
  bool is_within_increment_ = false;
  std::optional<std::chrono::steady_clock::time_point> begin_;  // of run(), during it
  double seconds_before_ = 0;
  std::string note_;
};

}  // namespace perimpact
