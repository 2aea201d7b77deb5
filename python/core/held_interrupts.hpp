/// Ctrl-C while a step is made. Own forces are Python, and Python's own handler would raise KeyboardInterrupt in the middle of one, which leaves the step
/// half done. So a signal is only noted as long as one of these lives, and handed to Python when the step is whole.
#pragma once

#include <pybind11/pybind11.h>

#include <csignal>

namespace perimpact::python {

class HeldInterrupts {
 public:
  /// With Python's lock held, which guards the count of those that live: several threads may make steps.
  HeldInterrupts() {
    if (living_++ > 0) return;
    struct sigaction noting {};
    noting.sa_handler = [](int) { noted_ = 1; };
    noting.sa_flags = SA_RESTART;
    sigaction(SIGINT, &noting, &of_python_);
  }
  /// Likewise.
  ~HeldInterrupts() {
    if (--living_ == 0) sigaction(SIGINT, &of_python_, nullptr);
  }
  HeldInterrupts(const HeldInterrupts&) = delete;
  HeldInterrupts& operator=(const HeldInterrupts&) = delete;

  /// Hands on what was noted: Python's handler for it is run when signals are looked for next.
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
