#include "io/deck/difference.hpp"

#include <doctest/doctest.h>

#include "io/deck/fixtures.hpp"
#include "io/deck/setup_to_text.hpp"

using namespace perimpact;
using deck::Difference;

namespace {

/// "key: before → now" of the plate deck and the plate deck with changes.
std::string difference(const std::vector<std::string>& before, const std::vector<std::string>& now) {
  const auto text = [](const std::vector<std::string>& changes) { return deck::setup_to_text(fixtures::read(fixtures::plate, changes).setup); };
  const auto found = deck::first_difference(text(before), text(now), [](std::string_view key) { return key == "output.folder"; });
  return found ? found->key + ": " + found->before + " -> " + found->now : "";
}

}  // namespace

TEST_CASE("difference: the first differing key is reported with both values") {
  CHECK(difference({}, {}).empty());
  CHECK(difference({"bodies.plate.spacing=1 mm"}, {"bodies.plate.spacing=0.001"}).empty());  // what counts is the value, not how it is written
  CHECK(difference({}, {"bodies.plate.material.poissons_ratio=0.3"}) == "bodies.plate.material.poissons_ratio: 0.25 -> 0.3");
  CHECK(difference({}, {"impactors.cylinder.velocity=[0, -16, 0]"}) == "impactors.cylinder.velocity: [0, -32, 0] -> [0, -16, 0]");
  CHECK(difference({}, {"output.frames=9", "time.end=1 ms"}) == "time.end: 0.0002 -> 0.001");
}

TEST_CASE("difference: a key present in only one deck is a difference") {
  CHECK(difference({}, {"bodies.plate.material.critical_stretch=0.01"}) == "bodies.plate.material.critical_stretch:  -> 0.01");
  CHECK(difference({"bodies.plate.material.critical_stretch=0.01"}, {}) == "bodies.plate.material.critical_stretch: 0.01 -> ");
  CHECK(difference({"impactors.cylinder.gauges.hub={}"}, {}) == "impactors.cylinder.gauges.hub: a map -> ");
}

TEST_CASE("difference: exempt keys are ignored, and long lists are cut") {
  CHECK(difference({}, {"output.folder=elsewhere"}).empty());
  std::string times = "[0";
  for (int k = 1; k < 50; ++k) times += ", " + std::to_string(k);
  const std::string load = "impactors.cylinder.loads.push={force: [0, 1, 0], times: " + times + "], factors: " + times + "]}";
  const std::string message = difference({load}, {load, "impactors.cylinder.loads.push.times=" + times + ".5]"});
  CHECK(message.starts_with("impactors.cylinder.loads.push.times: [0, 1, 2, "));
  CHECK(message.size() < 250);
}
