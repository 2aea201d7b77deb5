/// Ranks as on a slow network: every call takes the time of its messages longer, and messages under way arrive that much after they were sent. For
/// measurements of what a network costs, and of what is hidden behind computation.
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
    std::this_thread::sleep_for(duration_of(sent));
    call();
  }
  template <class Call>
  std::unique_ptr<Exchange> begin(const Traffic& sent, const Call& call) {
    using SteadyClock = std::chrono::steady_clock;
    struct Delayed final : Exchange {
      Delayed(SteadyClock::time_point arrival, std::unique_ptr<Exchange> exchange) : arrival_(arrival), exchange_(std::move(exchange)) {}
      void complete() override {
        exchange_->complete();
        std::this_thread::sleep_until(arrival_);
      }
      SteadyClock::time_point arrival_;
      std::unique_ptr<Exchange> exchange_;
    };
    const auto arrival = SteadyClock::now() + std::chrono::duration_cast<SteadyClock::duration>(duration_of(sent));
    return std::make_unique<Delayed>(arrival, call());
  }
  std::chrono::duration<double> duration_of(const Traffic& sent) const { return std::chrono::duration<double>(network_.seconds_of(sent, size())); }

  Network network_;
};

}  // namespace perimpact
