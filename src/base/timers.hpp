/// Wall-clock timers of the phases of a run.
#pragma once

#include <chrono>
#include <functional>
#include <string_view>
#include <utility>
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
    add(name, begin);
  }

  /// Adds the time since `begin` to the row `name`.
  void add(std::string_view name, std::chrono::steady_clock::time_point begin) {
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

/// Stages of a set-up, one after the other: announced when they begin, so that a long one can be shown, and timed.
class Stages {
 public:
  /// `stage`: a literal; `of`: the body or impactor, or empty.
  using Announce = std::function<void(std::string_view stage, std::string_view of)>;

  explicit Stages(Announce announce = {}) : announce_(std::move(announce)) {}

  /// Ends the stage before, if it has not ended.
  void begin(std::string_view stage, std::string_view of = {}) {
    end();
    if (announce_) announce_(stage, of);
    name_ = stage, begin_ = std::chrono::steady_clock::now();
  }
  void end() {
    if (!name_.empty()) timers_.add(name_, begin_);
    name_ = {};
  }

  const Timers& timers() const { return timers_; }  ///< of the stages that have ended

 private:
  Announce announce_;
  std::string_view name_;  // empty between stages
  std::chrono::steady_clock::time_point begin_;
  Timers timers_;
};

}  // namespace fccda
