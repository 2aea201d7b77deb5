/// The duration of messages by a simple model: a latency for each, and a bandwidth for their bytes. Messages do not obstruct each other.
#pragma once

#include <bit>

#include "perimpact/ranks/traffic.hpp"

namespace perimpact {

struct Network {
  double latency = 2e-6;    ///< [s] of a message
  double bandwidth = 1e10;  ///< [byte/s] with which a rank sends

  /// [s] for what a rank sends. A collective call of so many ranks is a binary tree of messages.
  double seconds_of(const Traffic& sent, int ranks) const {
    const int levels = std::bit_width(static_cast<unsigned>(ranks - 1));
    const auto messages = static_cast<double>(sent.messages + levels * (sent.reductions + sent.collections));
    return messages * latency + static_cast<double>(sent.bytes + levels * (sent.reduced_bytes + sent.collected_bytes)) / bandwidth;
  }
};

}  // namespace perimpact
