/// A checkpoint: all that a run needs to go on after it was stopped, and to end with the very same bits (docs/guide/restart.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "io/checkpoint/arrays_reader.hpp"
#include "io/results/written.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

/// A fingerprint of a simulation that was just made: of its first state and of what the files hold that its deck names. So a file that was
/// changed is seen, and a program that was built otherwise.
std::uint64_t fingerprint_at_start(Simulation& simulation);

/// Replaces the file as a whole, so that there is always one. Throws RunError where it cannot be written; the one before then stays.
void write_checkpoint(const std::filesystem::path& path, Simulation& simulation, std::uint64_t at_start, Written written);

/// One that is there.
class Checkpoint {
 public:
  /// Throws InputError where there is none, where it is not whole, or where another version of the program wrote it.
  explicit Checkpoint(const std::filesystem::path& path);

  long step() const { return step_; }    ///< that had been done
  long steps() const { return steps_; }  ///< of the whole run
  bool is_finished() const { return step_ >= steps_; }

  /// Throws SetupError, with the key, where the deck that was run says something else. Where results go and how often a checkpoint is
  /// written may differ, and names of files.
  void expect_deck(const Setup& setup);

  /// Brings a simulation that was just made, with that fingerprint, to where the run was. Throws InputError where the file is damaged, or
  /// the simulation is not the one that was run. Returns what had been written of its results.
  Written restore(Simulation& simulation, std::uint64_t at_start);

 private:
  std::filesystem::path path_;
  checkpoint::ArraysReader file_;
  long step_ = 0, steps_ = 0;
};

}  // namespace perimpact
