#include "turns.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace perimpact::python {

namespace py = pybind11;

namespace {

constexpr std::chrono::milliseconds between_looks{50};  // for signals, while a thread waits
constexpr std::chrono::seconds longest_call{5};         // while others wait

}  // namespace

void Turns::wait_for_step() const {
  if (!is_in_step_ || stepping_ == std::this_thread::get_id()) return;
  struct Waiting {
    explicit Waiting(const Turns& of) : turns(of) { ++turns.waiting_; }
    ~Waiting() {
      {
        const std::lock_guard lock(turns.mutex_);
        --turns.waiting_;
      }
      turns.changed_.notify_all();
    }
    const Turns& turns;
  } const waiting(*this);
  while (is_in_step_) {
    if (call_began_ && std::chrono::steady_clock::now() - *call_began_ > longest_call)
      throw fccda::RunError(
          fmt::format("a step is in progress, and a user force or structure that it has called did not return within {} s; read the state between steps, or "
                      "within the function in the thread that calls it.",
                      longest_call.count()));
    {
      const py::gil_scoped_release release;
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, between_looks, [&] { return !is_in_step_; });
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

void Turns::let_others_read() const {
  if (!others_wait()) return;
  const py::gil_scoped_release release;
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !others_wait(); });
}

Turns::Step::Step(Turns& turns) : turns_(turns) {
  const std::lock_guard lock(turns_.mutex_);
  turns_.stepping_ = std::this_thread::get_id();
  turns_.is_in_step_ = true;
}

Turns::Step::~Step() {
  {
    const std::lock_guard lock(turns_.mutex_);
    turns_.is_in_step_ = false;
  }
  turns_.changed_.notify_all();
}

}  // namespace perimpact::python
