/// Ranks as on a slow network: every call takes the time of its messages longer. For measurements of what a network costs.
#pragma once

#include <chrono>
#include <thread>

#include "perimpact/ranks/decorated_ranks.hpp"
#include "perimpact/ranks/network.hpp"

namespace perimpact {

class DelayedRanks final : public DecoratedRanks<DelayedRanks> {
 public:
  DelayedRanks(Ranks& inner, const Network& network) : DecoratedRanks(inner), network_(network) {}

 private:
  friend DecoratedRanks;
  template <class Call>
  void around(const Traffic& sent, const Call& call) {
    std::this_thread::sleep_for(std::chrono::duration<double>(network_.seconds_of(sent, size())));
    call();
  }

  Network network_;
};

}  // namespace perimpact
