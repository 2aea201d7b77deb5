/// Deferral of Ctrl-C during a step. User forces run Python code, in which Python's handler would raise KeyboardInterrupt and leave the step
/// incomplete. While an object exists a signal is only recorded, and it is passed to Python when the step is complete.
#pragma once

#include <pybind11/pybind11.h>

#include <csignal>

namespace perimpact::python {

class HeldInterrupts {
 public:
  /// Call with the GIL held, which guards the number of objects: several threads may perform steps.
  HeldInterrupts() {
    if (living_++ > 0) return;
    struct sigaction noting {};
    noting.sa_handler = [](int) { noted_ = 1; };
    noting.sa_flags = SA_RESTART;
    sigaction(SIGINT, &noting, &of_python_);
  }
  /// Call with the GIL held.
  ~HeldInterrupts() {
    if (--living_ == 0) sigaction(SIGINT, &of_python_, nullptr);
  }
  HeldInterrupts(const HeldInterrupts&) = delete;
  HeldInterrupts& operator=(const HeldInterrupts&) = delete;

  /// Passes on a recorded signal: Python's handler runs at the next check for signals.
  static void hand_on() {
    if (noted_ == 0) return;
    noted_ = 0;
    PyErr_SetInterrupt();
  }

 private:
  static inline int living_ = 0;
  static inline struct sigaction of_python_ {};
  static inline volatile std::sig_atomic_t noted_ = 0;
};

}  // namespace perimpact::python
