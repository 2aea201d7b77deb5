/// Progress of a run.
#pragma once

#include <chrono>
#include <string>

#include "cli/messages.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

class Progress {
 public:
  Progress(const Simulation& simulation, Messages& messages);
  void after_step(const Simulation& simulation);
  void in_increment(const Simulation& simulation);  ///< of a relaxation increment, which may take long
  void finish(const Simulation& simulation);        ///< prints a last time

 private:
  struct Reached;
  Reached reached(const Simulation& simulation, long done) const;

  Messages& messages_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  long first_;  // step
};

/// "3 h 12 min", "4 min 05 s", "38 s"
std::string duration_in_words(double seconds);

}  // namespace perimpact
