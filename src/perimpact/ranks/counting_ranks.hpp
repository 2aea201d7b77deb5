/// Ranks that count and time what is sent.
#pragma once

#include <chrono>

#include "perimpact/ranks/decorated_ranks.hpp"

namespace perimpact {

class CountingRanks final : public DecoratedRanks<CountingRanks> {
 public:
  using DecoratedRanks::DecoratedRanks;
  Traffic traffic() const override { return traffic_; }

 private:
  friend DecoratedRanks;
  template <class Call>
  void around(const Traffic& sent, const Call& call) {
    const auto begin = std::chrono::steady_clock::now();
    call();
    traffic_ += sent;
    traffic_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  Traffic traffic_;
};

}  // namespace perimpact
