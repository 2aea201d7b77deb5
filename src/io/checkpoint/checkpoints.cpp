#include "io/checkpoint/checkpoints.hpp"

namespace perimpact {

Checkpoints::Checkpoints(std::filesystem::path path, Simulation& simulation)
    : path_(std::move(path)), every_(simulation.setup().output.checkpoint_interval), at_start_(fingerprint_at_start(simulation)) {}

Written Checkpoints::resume(Checkpoint& from, Simulation& simulation) {
  Written written = from.restore(simulation, at_start_);
  last_ = from.step();
  return written;
}

void Checkpoints::after_step(Simulation& simulation, ResultsWriter& results) {
  const auto now = std::chrono::steady_clock::now();
  if (every_ > 0 && std::chrono::duration<double>(now - written_).count() >= every_) write(simulation, results);
}

void Checkpoints::write(Simulation& simulation, ResultsWriter& results) {
  if (last_ != simulation.clock().step) write_checkpoint(path_, simulation, at_start_, results.written());
  last_ = simulation.clock().step;
  written_ = std::chrono::steady_clock::now();
}

}  // namespace perimpact
