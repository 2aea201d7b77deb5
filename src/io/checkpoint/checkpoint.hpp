/// Checkpoint of a run for a bitwise-exact restart (docs/guide/restart.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/checkpoint/arrays_reader.hpp"
#include "io/results/written.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

/// Hash of a newly built simulation: of its initial state and the contents of the files that its deck refers to. It detects changed input files and
/// a differently built program.
std::uint64_t fingerprint_at_start(Simulation& simulation);

/// Writes a checkpoint, replacing the file atomically. Throws RunError where it cannot be written; the previous file then remains.
void write_checkpoint(const std::filesystem::path& path, Simulation& simulation, std::uint64_t at_start, Written written);

/// An existing checkpoint.
class Checkpoint {
 public:
  /// Opens it. Throws InputError where it does not exist, is incomplete, or was written by another version of the program.
  explicit Checkpoint(const std::filesystem::path& path);

  long step() const { return step_; }    ///< number of completed steps
  long steps() const { return steps_; }  ///< number of steps of the entire run
  double end() const { return end_; }    ///< [s] time.end of the run

  /// What the parts of each body cost the ranks of the run; nothing of a run of one rank.
  std::vector<MeasuredLoad> loads(const Setup& setup);

  /// Throws SetupError with the key where the deck differs from that of the run. The results folder, checkpoint settings and file paths may
  /// differ, and time.end may be later; restore() verifies that steps, rows and output frames up to the checkpoint remain the same.
  void expect_deck(const Setup& setup);

  /// Throws InputError on all ranks if the root finds that the file is damaged: within restore() the root alone would. Collective.
  void expect_intact(Ranks& ranks);

  /// Restores the state of the run into a newly built simulation with the hash `at_start`. Throws InputError where the file is damaged, or the
  /// simulation differs from that of the run. Returns the amount of output written so far.
  Written restore(Simulation& simulation, std::uint64_t at_start);

 private:
  void expect_same_steps(const Simulation& simulation);

  std::filesystem::path path_;
  checkpoint::ArraysReader file_;
  long step_ = 0, steps_ = 0;
  double end_ = 0;
};

}  // namespace perimpact
