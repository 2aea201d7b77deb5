/// Checkpoints of a run: when they are written, how many are kept, and from which one a run resumes.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/checkpoint/checkpoint.hpp"
#include "io/results/results_writer.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

/// True if the folder contains a checkpoint of any age.
bool has_checkpoint(const std::filesystem::path& folder);

struct Reached {
  long step, steps;  ///< completed, and of the whole run
  double end;        ///< [s] time.end of the run
  std::vector<MeasuredLoad> loads = {};
};
/// What the newest readable checkpoint of the folder has reached. Throws InputError where none can be read: the error of the latest.
Reached newest_checkpoint(const std::filesystem::path& folder);
/// The same, with the loads of its bodies; throws SetupError where the deck differs from that of the run.
Reached newest_checkpoint(const std::filesystem::path& folder, const Setup& setup);

class Checkpoints {
 public:
  /// For a newly built simulation.
  Checkpoints(std::filesystem::path folder, Simulation& simulation);

  /// Restores the newest checkpoint that is intact, which counts as the last one. Throws as newest_checkpoint and Checkpoint::restore.
  Written resume(Simulation& simulation);
  /// A sentence, if that was not the latest; empty otherwise.
  const std::string& note() const { return note_; }

  /// Call after every step, when its results have been written. Writes a checkpoint when output.checkpoint_interval of wall-clock time has
  /// passed, and before the last step: a longer run has this state too, so that the run can be prolonged.
  void after_step(Simulation& simulation, ResultsWriter& results);

  /// Writes a checkpoint immediately, unless the last one is of this step.
  void write(Simulation& simulation, ResultsWriter& results);
  /// The same within an increment of relaxation, which changes the state but not the step.
  void write_within_increment(Simulation& simulation, ResultsWriter& results);

  std::optional<long> last() const { return last_; }  ///< step of the last checkpoint, if any

 private:
  void rotate() const;

  std::filesystem::path folder_;
  double every_;  // [s] wall-clock interval; 0: none
  int kept_;
  int resumed_age_ = 0;  // of the checkpoint from which the run resumed; later ones are damaged
  std::uint64_t at_start_;
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
  std::optional<long> last_;
  std::string note_;
};

}  // namespace perimpact
