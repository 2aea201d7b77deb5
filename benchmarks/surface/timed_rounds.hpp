/// Processor time and memory of the stages of a single-threaded program.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace benchmark {

/// Peak memory of this program [MiB]. getrusage would include the memory of the parent process.
inline double peak_memory() {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kibibytes = 0;
  while (status >> word && word != "VmHWM:") {
  }
  status >> kibibytes;
  return kibibytes / 1024;
}

/// Timer of stages; call each stage once per round, in the same order.
class TimedRounds {
 public:
  template <class Work>
  auto operator()(const std::string& stage, const Work& work) {
    const std::clock_t begin = std::clock();
    auto result = work();
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const auto known = std::find_if(stages_.begin(), stages_.end(), [&](const Stage& s) { return s.name == stage; });
    if (known == stages_.end())
      stages_.push_back({stage, {seconds}, peak_memory()});
    else
      known->seconds.push_back(seconds);
    return result;
  }

  /// Prints a row per stage: name, median of the rounds [s], peak memory up to the end of the stage in the first round [MiB].
  void print() {
    fmt::print("stage,seconds,memory_mib\n");
    for (Stage& stage : stages_) {
      const auto middle = stage.seconds.begin() + static_cast<std::ptrdiff_t>(stage.seconds.size() / 2);
      std::nth_element(stage.seconds.begin(), middle, stage.seconds.end());
      fmt::print("{},{:.4g},{:.4g}\n", stage.name, *middle, stage.memory);
    }
  }

 private:
  struct Stage {
    std::string name;
    std::vector<double> seconds;
    double memory;
  };
  std::vector<Stage> stages_;
};

}  // namespace benchmark
