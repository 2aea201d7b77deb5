/// Parallel loops. Work is divided into the same chunks for any number of threads, and each chunk writes only its own data,
/// so results are bitwise reproducible across thread counts.
#pragma once

#include <omp.h>

#include <cstddef>

namespace fccda {

/// Calls body(i) for i in [0, count), each once, in any order.
template <class Body>
void parallel_for(std::ptrdiff_t count, const Body& body) {
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < count; ++i) body(i);
}

/// The same for iterations of very uneven cost, scheduled dynamically in chunks of eight. Fewer than that run on the calling thread.
template <class Body>
void parallel_for_uneven(std::ptrdiff_t count, const Body& body) {
#pragma omp parallel for schedule(dynamic, 8) if (count > 8)
  for (std::ptrdiff_t i = 0; i < count; ++i) body(i);
}

/// Number of threads of parallel loops.
inline int thread_count() { return omp_get_max_threads(); }
/// Sets the number of threads of parallel loops, at least 1.
inline void use_threads(int count) { omp_set_num_threads(count); }

}  // namespace fccda
