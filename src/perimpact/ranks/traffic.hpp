/// What a rank sends to others.
#pragma once

#include <cstdint>

namespace perimpact {

/// Counts of the messages of one rank, by kind of call. How MPI combines or forwards the bytes of a collective call is its own affair.
struct Traffic {
  std::int64_t messages = 0, bytes = 0;               ///< sent to single ranks, as ghosts are
  std::int64_t reductions = 0, reduced_bytes = 0;     ///< sums and largest values over all ranks, and what this rank contributes
  std::int64_t collections = 0, collected_bytes = 0;  ///< gathered and broadcast bytes, those of this rank
  double seconds = 0;                                 ///< [s] wall-clock time in these calls: waiting, and transfer

  Traffic& operator+=(const Traffic& other) {
    messages += other.messages, bytes += other.bytes;
    reductions += other.reductions, reduced_bytes += other.reduced_bytes;
    collections += other.collections, collected_bytes += other.collected_bytes;
    seconds += other.seconds;
    return *this;
  }
  Traffic& operator-=(const Traffic& other) {
    messages -= other.messages, bytes -= other.bytes;
    reductions -= other.reductions, reduced_bytes -= other.reduced_bytes;
    collections -= other.collections, collected_bytes -= other.collected_bytes;
    seconds -= other.seconds;
    return *this;
  }
};

/// One sum or largest value over all ranks, of so many numbers of eight bytes.
constexpr Traffic reduction_of(std::int64_t numbers) { return {.reductions = 1, .reduced_bytes = 8 * numbers}; }

}  // namespace perimpact
