/// When a run writes its checkpoints.
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
  /// Of a simulation that was just made; `path`: of the one file, replaced each time.
  Checkpoints(std::filesystem::path path, Simulation& simulation);

  /// Goes on from one: it counts as the last.
  Written resume(Checkpoint& from, Simulation& simulation);

  /// Call after every step, when its results have been written. Writes one where output.checkpoint_interval has passed.
  void after_step(Simulation& simulation, ResultsWriter& results);

  /// Writes one now.
  void write(Simulation& simulation, ResultsWriter& results);

  const std::filesystem::path& path() const { return path_; }
  std::optional<long> last() const { return last_; }  ///< step of the last one, if there is one

 private:
  std::filesystem::path path_;
  double every_;  // [s]; 0: none by the clock
  std::uint64_t at_start_;
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
  std::optional<long> last_;
};

}  // namespace perimpact
