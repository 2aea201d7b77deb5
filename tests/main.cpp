#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "fixtures/tolerance.hpp"

namespace {

/// What was compared at one place of the sources.
struct Comparisons {
  long made = 0;
  long equal = 0;
  bool is_relative = false;
  const char* unit = nullptr;
  double smallest = std::numeric_limits<double>::infinity();  ///< of the magnitudes expected
  double largest = 0;
  double tolerance = 0;  ///< the widest; a share where it is relative
  double deviation = 0;  ///< the largest |found - expected|, in tolerances
};

/// All comparisons of the program; written when it ends.
class Record {
 public:
  void add(const fixtures::Expected& expected, double found, bool is_equal) {
    const std::lock_guard lock(mutex_);
    Comparisons& here = at_[{expected.file, expected.line}];
    const double magnitude = std::fabs(expected.value);
    here.made += 1;
    here.equal += is_equal;
    here.is_relative = !expected.unit;
    here.unit = expected.unit ? expected.unit : "";
    here.smallest = std::min(here.smallest, magnitude);
    here.largest = std::max(here.largest, magnitude);
    here.tolerance = std::max(here.tolerance, expected.unit ? expected.tolerance : expected.tolerance / magnitude);
    here.deviation = std::max(here.deviation, std::fabs(found - expected.value) / expected.tolerance);
  }

  void write(const char* path) const {
    std::FILE* file = std::fopen(path, "w");
    if (!file) return;
    std::fprintf(file, "file,line,made,equal,kind,unit,smallest,largest,tolerance,deviation\n");
    for (const auto& [place, c] : at_)
      std::fprintf(file, "%s,%d,%ld,%ld,%s,%s,%.6g,%.6g,%.6g,%.6g\n", place.first.c_str(), place.second, c.made, c.equal,
                   c.is_relative ? "relative" : "absolute", c.unit, c.smallest, c.largest, c.tolerance, c.deviation);
    std::fclose(file);
  }

 private:
  std::mutex mutex_;
  std::map<std::pair<std::string, int>, Comparisons> at_;
};

const char* const path_of_record = std::getenv("PERIMPACT_COMPARISONS");

Record& record() {
  static Record all;
  static const int at_end = std::atexit([] { record().write(path_of_record); });
  (void)at_end;
  return all;
}

}  // namespace

void fixtures::record_comparison(const Expected& expected, double found, bool is_equal) {
  if (path_of_record) record().add(expected, found, is_equal);
}
