#include "perimpact/diagnostics/proximity.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "perimpact/bodies.hpp"
#include "perimpact/simulation/simulation.hpp"

using namespace perimpact;

namespace {

/// A block and a cube that flies past its upper face.
Setup flyby() {
  Setup setup;
  setup.time = {.end = 40e-6, .step = 2e-7};
  BodySetup block = fixtures::body_setup({.size = {0.032, 0.02, 0.016}, .spacing = 0.002});
  block.name = "block";
  setup.bodies = {block};
  ImpactorSetup cube;
  cube.name = "cube";
  cube.surface = BoxSurface{.size = {0.01, 0.01, 0.01}, .edge_length = 0.005};
  cube.mass = 1;
  cube.position = {-0.03, 0.018, 0};  // 3 mm above the face
  cube.velocity = {1500, 0, 0};
  setup.impactors = {cube};
  setup.output.history_interval = 1e-6;
  return setup;
}

std::vector<std::string> closing(const Setup& setup) {
  Simulation simulation(setup);
  while (!simulation.clock().is_finished()) simulation.step();
  return simulation.closing_warnings();
}

}  // namespace

TEST_CASE("proximity: an impactor without contact is reported with its smallest distance and the time of it") {
  const std::vector<std::string> warnings = closing(flyby());
  REQUIRE(warnings.size() == 1);
  // over the block it is 3 mm away from contact; it gets there at x = -21 mm, after 6 µs, and is sampled a hundred times in the 40 µs
  const std::string sentence = "Impactor cube had no contact with body block until t = 4e-05 s: the smallest distance was 0.003 m, at t = ";
  CHECK(warnings[0].starts_with(sentence));
  const double time = std::stod(warnings[0].substr(sentence.size()));
  CHECK(time > 6e-6);
  CHECK(time < 7e-6);
}

TEST_CASE("proximity: an impactor that moves away was nearest at the start, at the distance of its corner") {
  Setup setup = flyby();
  setup.impactors[0].velocity = {-1500, 0, 0};
  const std::vector<std::string> warnings = closing(setup);
  REQUIRE(warnings.size() == 1);
  const double gap = std::hypot(0.010, 0.004) - 0.001;  // corner at (-25, 13) mm, particle at (-15, 9) mm, contact radius 1 mm
  CHECK(warnings[0].find(fmt::format("smallest distance was {:.3g} m, at t = 0 s.", gap)) != std::string::npos);
}

TEST_CASE("proximity: contact yields no warning") {
  Setup setup = flyby();
  setup.impactors[0].position = {0, 0.016, 0};
  setup.impactors[0].velocity = {0, -100, 0};
  CHECK(closing(setup).empty());
}

TEST_CASE("proximity: particles that penetrate where contact bounds clip are counted, with the time of the first") {
  Setup setup = flyby();
  setup.impactors[0].position = {0, 0.016, 0};
  setup.impactors[0].velocity = {0, -200, 0};
  setup.impactors[0].contact_bounds = {BoxRegionSetup{.size = {0.012, 0.006, 0.012}, .centre = {0, 0.001, 0}},
                                       Choice{on_exceed_words, 1}};  // without its front
  const std::vector<std::string> warnings = closing(setup);
  REQUIRE(!warnings.empty());
  const std::string& last = warnings.back();
  CHECK(last.find(" particles of body block penetrated impactor cube outside the contact bounds, the first by t = ") != std::string::npos);
  CHECK(last.find("Enlarge impactors.cube.contact_bounds.") != std::string::npos);
  const double first = std::stod(last.substr(last.find("t = ") + 4));
  // The contact bounds begin 2 mm before the cube's centre, and contact is searched from a contact radius of 1 mm before. The centre is 7 mm from the
  // first particles at the start, which nothing stops before: 20 to 25 µs at 200 m/s, and up to 1 µs to the next row.
  CHECK(first >= 19.9e-6);
  CHECK(first <= 26e-6);
}
