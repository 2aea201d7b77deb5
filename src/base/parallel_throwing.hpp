/// A parallel loop whose iterations may throw: an exception must not leave an OpenMP region, which would end the program.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>

#include "base/parallel.hpp"

namespace fccda {

/// Calls body(i) for i in [0, count), each once, in any order; rethrows one of the exceptions after the loop.
template <class Body>
void parallel_for_throwing(std::ptrdiff_t count, const Body& body) {
  std::atomic_flag has_failed = ATOMIC_FLAG_INIT;
  std::exception_ptr failure;
  parallel_for(count, [&](std::ptrdiff_t i) {
    try {
      body(i);
    } catch (...) {
      if (!has_failed.test_and_set()) failure = std::current_exception();
    }
  });
  if (failure) std::rethrow_exception(failure);
}

}  // namespace fccda
