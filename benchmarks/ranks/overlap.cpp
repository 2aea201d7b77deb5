/// How much of the exchange of ghosts is hidden behind the forces on the interior: steps as they are, and on a network so slow that the messages of a step take
/// half as long as those forces. CSV on standard output.
///
///   overlap_benchmark cases/plate_impact/deck.yaml --set bodies.plate.material.poissons_ratio=0.3
///
/// Ranks are threads of one process, each with one thread, and need a core each. The interior are the owned cells that no other rank needs. Both networks are
/// measured in turn, once a round; results are medians over the rounds.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <mutex>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "io/deck/deck.hpp"
#include "perimpact/ranks/counting_ranks.hpp"
#include "perimpact/ranks/delayed_ranks.hpp"
#include "perimpact/ranks/in_process.hpp"
#include "perimpact/simulation/rank_forecast.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace {

using namespace perimpact;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Times the exchanges of ghosts: while they begin, and while their completion is awaited.
class TimedExchanges final : public DecoratedRanks<TimedExchanges> {
 public:
  using DecoratedRanks::DecoratedRanks;
  double seconds = 0;

 private:
  friend DecoratedRanks;
  template <class Call>
  void around(const Traffic&, const Call& call) {
    call();
  }
  template <class Call>
  std::unique_ptr<Exchange> begin(const Traffic&, const Call& call) {
    struct Timed final : Exchange {
      Timed(double& of, std::unique_ptr<Exchange> inner) : seconds(of), exchange(std::move(inner)) {}
      void complete() override {
        const double begin = now();
        exchange->complete();
        seconds += now() - begin;
      }
      double& seconds;
      std::unique_ptr<Exchange> exchange;
    };
    const double begin = now();
    std::unique_ptr<Exchange> exchange = call();
    seconds += now() - begin;
    return std::make_unique<Timed>(seconds, std::move(exchange));
  }
};

struct Measured {
  double step = 0, exchanges = 0, forces = 0;  // [s] of a step, means over the ranks; forces without messages
};

Measured measure(const Setup& setup, int ranks, int steps, const Network& network) {
  Measured mean;
  std::mutex mutex;
  run_in_process(ranks, [&](Ranks& inner) {
    DelayedRanks delayed(inner, network);
    TimedExchanges timed(delayed);
    CountingRanks counting(timed);
    Simulation simulation(setup, {}, counting);
    constexpr int warm_up = 10;
    for (int step = 0; step < warm_up; ++step) simulation.step();
    const double begin = now(), exchanges = timed.seconds, forces = simulation.seconds_of_forces();
    for (int step = 0; step < steps; ++step) simulation.step();
    const double end = now(), share = 1.0 / (ranks * steps);
    const std::lock_guard guard(mutex);
    mean.step += share * (end - begin);
    mean.exchanges += share * (timed.seconds - exchanges);
    mean.forces += share * (simulation.seconds_of_forces() - forces);
  });
  return mean;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  std::string file;
  std::vector<std::string> set;
  int ranks = 2, steps = 50, rounds = 5;
  CLI::App app("Times the exchanges of ghosts that computation hides; prints CSV.");
  app.add_option("deck", file, "the deck; its first body is measured")->required()->check(CLI::ExistingFile);
  app.add_option("--set", set, "key.path=value: changes the deck")->allow_extra_args(false);
  app.add_option("--ranks", ranks, "number of ranks")->check(CLI::Range(2, 64));
  app.add_option("--steps", steps, "timed steps of a round")->check(CLI::PositiveNumber);
  app.add_option("--rounds", rounds, "number of rounds")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  fccda::use_threads(1);
  const Setup setup = deck::read_deck(file, set).setup;
  const BodySetup& body = setup.bodies.front();
  const Discretisation discretisation = discretise(body);
  RanksInTurn in_turn(ranks);
  double interior = 1, sent_slots = 0;  // share of the owned cells, and of the rank that sends most
  for (const BodyShare& share : shares_of_ranks(body, discretisation, in_turn)) {
    interior = std::min(interior, std::max(0.0, 1 - share.sent_slots / share.cells));
    sent_slots = std::max(sent_slots, share.sent_slots);
  }
  double bytes = 0;  // sent in a step
  for (const std::size_t of_slot : messages_of_body(body, discretisation).refreshed) bytes += sent_slots * static_cast<double>(of_slot);

  const Network immediate{.latency = 0, .bandwidth = 1e300};
  const double delay = 0.5 * interior * measure(setup, ranks, steps, immediate).forces;
  const Network slow{.latency = 0, .bandwidth = bytes / delay};  // without latency, so that reductions are not delayed noticeably
  std::vector<double> step, slow_step, waiting, slow_waiting, ratio;
  for (int round = 0; round < rounds; ++round) {
    const Measured as_is = measure(setup, ranks, steps, immediate), delayed = measure(setup, ranks, steps, slow);
    step.push_back(1e3 * as_is.step), slow_step.push_back(1e3 * delayed.step);
    waiting.push_back(1e3 * as_is.exchanges), slow_waiting.push_back(1e3 * delayed.exchanges);
    ratio.push_back(delayed.step / as_is.step);
  }
  fmt::print("ranks,rounds,interior,step [ms],waiting [ms],delay [ms],delayed step [ms],delayed waiting [ms],delayed/as it is,least,largest\n");
  fmt::print("{},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f}\n", ranks, rounds, interior, median(step), median(waiting), 1e3 * delay,
             median(slow_step), median(slow_waiting), median(ratio), std::ranges::min(ratio), std::ranges::max(ratio));
  return 0;
}
