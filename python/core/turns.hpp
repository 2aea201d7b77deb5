/// Who accesses the state of a simulation: a step, which runs without the GIL, or, between steps, a thread of Python that has the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace perimpact::python {

/// All members need the GIL, except others_wait().
class Turns {
 public:
  /// Waits until no step runs. Then no step begins as long as the caller keeps the GIL. Returns at once in the thread of the step, which then is in a call of
  /// Python. Throws RunError where that call has lasted for seconds, since it may be waiting for the caller.
  void wait_for_step() const;

  bool others_wait() const { return waiting_ > 0; }  ///< in wait_for_step(): the step should end soon
  void let_others_read() const;                      ///< returns when none of them waits
  bool is_in_step() const { return is_in_step_; }

  /// A step in this thread, in which others wait.
  class Step {
   public:
    explicit Step(Turns& turns);
    ~Step();
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

   private:
    Turns& turns_;
  };

  /// A call of Python by the step.
  class Call {
   public:
    explicit Call(Turns& turns) : turns_(turns) { turns_.call_began_ = std::chrono::steady_clock::now(); }
    ~Call() { turns_.call_began_.reset(); }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

   private:
    Turns& turns_;
  };

 private:
  bool is_in_step_ = false;  // changes with the GIL and the mutex
  std::thread::id stepping_;
  std::optional<std::chrono::steady_clock::time_point> call_began_;
  mutable std::atomic<int> waiting_ = 0;
  mutable std::mutex mutex_;                 // nobody waits for the GIL while it is locked
  mutable std::condition_variable changed_;  // is_in_step_ or waiting_
};

}  // namespace perimpact::python
