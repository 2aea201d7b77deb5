/// A parallel loop whose iterations may throw: an exception must not leave an OpenMP region, which would end the program.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>

#include "base/parallel.hpp"

namespace fccda {

/// Keeps one of the exceptions that calls throw, from any number of threads. A call that throws nothing costs nothing more.
class FirstFailure {
 public:
  /// Calls body().
  template <class Body>
  void guard(const Body& body) {
    try {
      body();
    } catch (...) {
      if (!has_failed_.test_and_set()) failure_ = std::current_exception();
    }
  }
  /// After all calls.
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::atomic_flag has_failed_ = ATOMIC_FLAG_INIT;
  std::exception_ptr failure_;
};

/// Calls body(i) for i in [0, count), each once, in any order; rethrows one of the exceptions after the loop.
template <class Body>
void parallel_for_throwing(std::ptrdiff_t count, const Body& body) {
  FirstFailure failure;
  parallel_for(count, [&](std::ptrdiff_t i) { failure.guard([&] { body(i); }); });
  failure.rethrow();
}

/// The same for iterations of very uneven cost.
template <class Body>
void parallel_for_uneven_throwing(std::ptrdiff_t count, const Body& body) {
  FirstFailure failure;
  parallel_for_uneven(count, [&](std::ptrdiff_t i) { failure.guard([&] { body(i); }); });
  failure.rethrow();
}

/// Calls f(first, last) for blocks of [0, count), as parallel_for_blocks().
template <class F>
void parallel_for_blocks_throwing(std::size_t count, std::size_t block, const F& f) {
  FirstFailure failure;
  parallel_for_blocks(count, block, [&](std::size_t first, std::size_t last) { failure.guard([&] { f(first, last); }); });
  failure.rethrow();
}

}  // namespace fccda
