/// Progress line of a run: redrawn on a terminal, one line every ten seconds in a file.
#pragma once

#include <chrono>

#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

class Progress {
 public:
  explicit Progress(const Simulation& simulation);
  void after_step(const Simulation& simulation);
  void in_increment(const Simulation& simulation);  ///< of a relaxation increment, which may take long
  void finish(const Simulation& simulation);        ///< draws a last time and ends the line
  double seconds() const;                           ///< since construction

 private:
  void draw_if_due(const Simulation& simulation, long done);
  void draw(const Simulation& simulation, double now, long done);

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  long first_;  // step
  bool is_terminal_;
  double drawn_ = 0;  // [s] time of the last line
};

/// "3 h 12 min", "4 min 05 s", "38 s"
std::string duration_in_words(double seconds);

}  // namespace perimpact
