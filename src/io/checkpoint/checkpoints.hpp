/// Scheduling of checkpoints during a run.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

#include "io/checkpoint/checkpoint.hpp"
#include "io/results/results_writer.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

class Checkpoints {
 public:
  /// For a newly built simulation; `path`: the single checkpoint file, replaced each time.
  Checkpoints(std::filesystem::path path, Simulation& simulation);

  /// Restarts from a checkpoint, which counts as the last one.
  Written resume(Checkpoint& from, Simulation& simulation);

  /// Call after every step, when its results have been written. Writes a checkpoint when output.checkpoint_interval of wall-clock time has passed.
  void after_step(Simulation& simulation, ResultsWriter& results);

  /// Writes a checkpoint immediately.
  void write(Simulation& simulation, ResultsWriter& results);

  const std::filesystem::path& path() const { return path_; }
  std::optional<long> last() const { return last_; }  ///< step of the last checkpoint, if any

 private:
  std::filesystem::path path_;
  double every_;  // [s] wall-clock interval; 0: none
  std::uint64_t at_start_;
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
  std::optional<long> last_;
};

}  // namespace perimpact
