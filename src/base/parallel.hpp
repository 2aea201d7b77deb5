/// Parallel loops. Work is divided into the same chunks for any number of threads, and each chunk writes only its own data,
/// so results are bitwise reproducible across thread counts.
#pragma once

#include <omp.h>

#include <algorithm>
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

/// Whether iterations are distributed as by parallel_for() or by parallel_for_uneven().
enum class Schedule { even, uneven };
/// A parallel loop whose schedule is chosen at run time, so that a large body is compiled once.
template <class Body>
void parallel_for(std::ptrdiff_t count, Schedule schedule, const Body& body) {
  omp_set_schedule(schedule == Schedule::even ? omp_sched_static : omp_sched_dynamic, schedule == Schedule::even ? 0 : 8);
#pragma omp parallel for schedule(runtime)
  for (std::ptrdiff_t i = 0; i < count; ++i) body(i);
}

/// Calls f(first, last) for blocks of [0, count), of uneven cost, of `block` iterations each but for the last.
template <class F>
void parallel_for_blocks(std::size_t count, std::size_t block, const F& f) {
  parallel_for_uneven(static_cast<std::ptrdiff_t>((count + block - 1) / block), [&](std::ptrdiff_t b) {
    const std::size_t first = static_cast<std::size_t>(b) * block;
    f(first, std::min(first + block, count));
  });
}

/// Number of threads of parallel loops.
inline int thread_count() { return omp_get_max_threads(); }
/// Sets the number of threads of parallel loops, at least 1.
inline void use_threads(int count) { omp_set_num_threads(count); }

}  // namespace fccda
