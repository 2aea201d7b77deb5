/// Wall-clock timers of the phases of a run.
#pragma once

#include <chrono>
#include <string_view>
#include <vector>

namespace fccda {

class Timers {
 public:
  struct Row {
    std::string_view name;  ///< a literal
    double seconds = 0;
    std::size_t calls = 0;
  };

  /// Calls f() and adds its duration to the row `name`.
  template <class F>
  void timed(std::string_view name, const F& f) {
    const auto begin = std::chrono::steady_clock::now();
    f();
    Row& row = row_of(name);
    row.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    ++row.calls;
  }

  const std::vector<Row>& rows() const { return rows_; }  ///< in the order of their first call
  double total() const {
    double sum = 0;
    for (const Row& row : rows_) sum += row.seconds;
    return sum;
  }
  double seconds(std::string_view name) const {
    for (const Row& row : rows_)
      if (row.name == name) return row.seconds;
    return 0;
  }

 private:
  Row& row_of(std::string_view name) {
    for (Row& row : rows_)
      if (row.name == name) return row;
    return rows_.emplace_back(Row{name});
  }
  std::vector<Row> rows_;
};

}  // namespace fccda
