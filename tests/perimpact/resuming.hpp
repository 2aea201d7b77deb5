/// What must not change when a run is left off and taken up.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "fixtures/snapshot.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace fixtures {

using namespace perimpact;

/// Runs to the end, leaving off after every step: a simulation made anew is given the state and goes on.
inline void expect_same_when_resumed_at_every_step(const Setup& setup) {
  Simulation whole(setup);
  std::optional<Simulation> resumed(std::in_place, setup);
  while (!whole.clock().is_finished()) {
    const Snapshot snapshot(*resumed);
    resumed.emplace(setup);
    snapshot.give(*resumed);
    whole.step(), resumed->step();
    CAPTURE(whole.clock().step);
    REQUIRE(Snapshot(whole).differences(Snapshot(*resumed)) == std::vector<std::string>{});
    for (std::size_t i = 0; i < whole.impactors().size(); ++i) {
      const auto impulses = whole.impactors()[i].record().panels().since_start(), again = resumed->impactors()[i].record().panels().since_start();
      const bool same =
          std::equal(impulses.begin(), impulses.end(), again.begin(), again.end(), [](const auto& a, const auto& b) { return a.impulse == b.impulse; });
      REQUIRE(same);
    }
  }
  CHECK(resumed->closing_warnings() == whole.closing_warnings());
}

}  // namespace fixtures
