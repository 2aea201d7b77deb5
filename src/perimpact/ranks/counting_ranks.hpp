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
    traffic_ += sent;
    timed(call);
  }
  template <class Call>
  std::unique_ptr<Exchange> begin(const Traffic& sent, const Call& call) {
    struct Timed final : Exchange {
      Timed(CountingRanks& ranks, std::unique_ptr<Exchange> exchange) : ranks_(ranks), exchange_(std::move(exchange)) {}
      void complete() override {
        ranks_.timed([&] { exchange_->complete(); });
      }
      CountingRanks& ranks_;
      std::unique_ptr<Exchange> exchange_;
    };
    std::unique_ptr<Exchange> exchange;
    around(sent, [&] { exchange = call(); });
    return std::make_unique<Timed>(*this, std::move(exchange));
  }
  template <class Call>
  void timed(const Call& call) {
    const auto begin = std::chrono::steady_clock::now();
    call();
    traffic_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  Traffic traffic_;
};

}  // namespace perimpact
