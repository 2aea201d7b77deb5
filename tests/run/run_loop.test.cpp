#include "run/run_loop.hpp"

#include <doctest/doctest.h>

#include <mutex>
#include <vector>

#include "fixtures/temporary_folder.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/ranks/counting_ranks.hpp"
#include "perimpact/ranks/in_process.hpp"

using namespace perimpact;

TEST_CASE("run loop: between steps at which nothing is written it sends the reductions that it states, with and without checkpoints") {
  for (const double interval : {0.0, 300.0}) {
    CAPTURE(interval);
    Setup setup;
    setup.time = {.end = 1e-2, .step = 1e-8};
    setup.bodies = {fixtures::body_setup()};
    setup.output.checkpoint_interval = interval;
    const Traffic stated = RunLoop::collectives_in_step(setup.output);
    const ::fixtures::TemporaryFolder folder;
    std::mutex mutex;
    run_in_process(2, [&](Ranks& inner) {
      CountingRanks ranks(inner);
      Simulation simulation(setup, {}, ranks);
      RunLoop loop(simulation);
      const RunFolder results(folder / "r", EarlierRun::keep, {}, setup, ranks);
      loop.begin_results(results);
      std::vector<Traffic> after;  // each step: all that was sent, without what the step itself sent
      loop.run({.after_step =
                    [&] {
                      after.push_back(ranks.traffic());
                      after.back() -= simulation.traffic_of_steps();
                      return after.size() < 3;
                    },
                .in_increment = [] { return true; }});
      after[2] -= after[1];
      const std::lock_guard guard(mutex);
      CHECK(stated.reductions == (interval > 0 ? 3 : 2));
      CHECK(after[2].reductions == stated.reductions);
      CHECK(after[2].reduced_bytes == stated.reduced_bytes);
      CHECK(after[2].messages == 0);
      CHECK(after[2].collections == 0);
      CHECK(simulation.traffic_of_steps().messages > 0);
    });
  }
}
