// The main function of every test program.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "fixtures/larger.hpp"
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
    here.largest = fixtures::larger(here.largest, magnitude);
    here.tolerance = fixtures::larger(here.tolerance, expected.unit ? expected.tolerance : expected.tolerance / magnitude);
    here.deviation = fixtures::larger(here.deviation, std::fabs(found - expected.value) / expected.tolerance);
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

/// Test cases that the filters of the command line select.
unsigned selected = 0;

struct CountSelected : doctest::IReporter {
  explicit CountSelected(const doctest::ContextOptions&) {}
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats& stats) override { selected = stats.numTestCasesPassingFilters; }
  void test_case_start(const doctest::TestCaseData&) override {}
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats&) override {}
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
};
REGISTER_LISTENER("count of selected cases", 1, CountSelected);

}  // namespace

void fixtures::record_comparison(const Expected& expected, double found, bool is_equal) {
  if (path_of_record) record().add(expected, found, is_equal);
}

int main(int count, char** words) {
  doctest::Context context(count, words);
  const int failure = context.run();
  if (context.shouldExit() || selected > 0) return failure;  // shouldExit(): after a query, such as --list-test-cases
  std::fputs("No test case has such a title. ctest splits titles at semicolons.\n", stderr);
  return 1;
}
