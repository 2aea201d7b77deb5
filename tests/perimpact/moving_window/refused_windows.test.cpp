// Moving windows: what cannot move, what ends a run, and what is warned of.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/simulations.hpp"
#include "perimpact/window_scene.hpp"

using namespace perimpact;

namespace {

using fixtures::Model;
using fixtures::struck_strip;
using fixtures::window_after;

constexpr double spacing = fixtures::window_spacing;
constexpr int added = fixtures::window_added;

}  // namespace

TEST_CASE("moving window: a window whose front is damaged when it moves is reported at the end") {
  Setup setup = struck_strip(40, 0, Model::bond_based, 60);
  setup.impactors[0].position.x = -16 * spacing;
  setup.bodies[0].moving_window = window_after(20 * spacing);
  Simulation simulation(setup);
  fixtures::run(simulation);
  const std::vector<std::string> warnings = simulation.closing_warnings();
  CHECK(std::ranges::any_of(warnings, [](const std::string& one) { return one.find("the material at its front was damaged") != std::string::npos; }));
}

TEST_CASE("moving window: a run ends with a sentence where new material would be inside another impactor") {
  constexpr int cells = 64, steps = 20;
  for (const double beyond : {4.0, 20.0}) {  // [spacing] of a resting obstacle from the front
    Setup setup = struck_strip(cells, 0, Model::bond_based, steps);
    setup.bodies[0].moving_window = window_after(0);
    setup.impactors.push_back(fixtures::window_ball("pile", {-(cells / 2 + beyond) * spacing, 0, 0}, {}, 4 * spacing));
    Simulation simulation(setup);
    if (beyond > added + 2)
      CHECK_NOTHROW(fixtures::run(simulation));
    else
      CHECK_THROWS_WITH_AS(fixtures::run(simulation), doctest::Contains("The moving window of body body has reached impactor pile: "), fccda::RunError);
  }
}

TEST_CASE("moving window: a run ends with a sentence where new material would overlap another body") {
  constexpr int cells = 64, steps = 20;
  for (const double beyond : {4.0, 20.0}) {  // [spacing] of the nearest particles of another body from the front
    Setup setup = struck_strip(cells, 0, Model::bond_based, steps);
    setup.bodies[0].moving_window = window_after(0);
    BodySetup other = fixtures::body_setup({.size = {4 * spacing, 4 * spacing, 4 * spacing}, .spacing = spacing});
    other.name = "block", other.position = {-(cells / 2 + 2 + beyond) * spacing, 0, 0};
    setup.bodies.push_back(other);
    Simulation simulation(setup);
    if (beyond > added + 2)
      CHECK_NOTHROW(fixtures::run(simulation));
    else
      CHECK_THROWS_WITH_AS(fixtures::run(simulation), doctest::Contains("The moving window of body body has reached body block: "), fccda::RunError);
  }
}

TEST_CASE("moving window: a run ends with a sentence where free material would be put back into a fixed set") {
  constexpr int cells = 64, steps = 20;
  const auto fixed_over = [](double low, double high) {  // [spacing] from the rear, in travel along -x
    Setup setup = struck_strip(cells, 0, Model::bond_based, steps);
    setup.bodies[0].moving_window = window_after(0);
    SolidSetup set;
    set.name = "set", set.shape = BoxSolid{{(high - low) * spacing, 1, 2 * spacing}},
    set.position = {(cells / 2 - 0.5 * (low + high)) * spacing, 0, -2 * spacing};
    setup.bodies[0].particle_sets = {set};
    setup.bodies[0].boundary_conditions = {{"grip", FixedSetup{.particle_set = "set", .directions = {"x", "z"}}}};
    return setup;
  };
  for (const auto& [low, high] : {std::pair{-1, 4}, {20, 30}, {-1, 40}}) {
    Simulation simulation(fixed_over(low, high));
    CHECK_THROWS_WITH_AS(
        fixtures::run(simulation),
        doctest::Contains("body body moves along -x, and boundary condition body.grip would put back to its initial position material that was free"),
        fccda::RunError);
  }
  for (const auto& [low, high] : {std::pair{60, 65}, {-1, 65}, {40, 65}}) {
    Simulation simulation(fixed_over(low, high));
    CHECK_NOTHROW(fixtures::run(simulation));
  }
}

TEST_CASE("moving window: an impactor that does not move along the axis of the window gives a warning") {
  const auto warned = [](const Setup& setup) {
    return std::ranges::any_of(Simulation(setup).warnings(), [](const std::string& one) {
      return one.starts_with("The moving window of body body follows impactor guide, which does not move along y: ");
    });
  };
  Setup setup = struck_strip(40, 0, Model::bond_based, 10, {0, -1, 0});
  setup.bodies[0].moving_window = window_after(0, WindowAxis::y);
  CHECK(!warned(setup));
  setup.impactors[1].velocity = {-1, 0, 0};
  CHECK(warned(setup));
  setup.impactors[1].motion.y = TranslationTable{{{0, 1}, {-1, -1}, {}, {}}};
  CHECK(!warned(setup));
  setup.impactors[1].motion = {};
  setup.impactors[1].free_dofs = {"y"};
  CHECK(!warned(setup));
}

TEST_CASE("moving window: what cannot move is refused with its reason") {
  const auto refused = [](const std::function<void(Setup&)>& change, const std::string& words) {
    Setup setup = struck_strip(40, 0, Model::bond_based, 10);
    setup.bodies[0].moving_window = window_after(0);
    change(setup);
    const std::string sentence = fixtures::complaint(setup);
    CAPTURE(sentence);
    CHECK(sentence.starts_with("bodies.body.moving_window"));
    CHECK(sentence.find(words) != std::string::npos);
  };
  refused([](Setup& s) { s.bodies[0].moving_window->follow = "tug"; }, "follow: the window follows impactor tug, which does not exist");
  refused([](Setup& s) { std::get<BoxSolid>(s.bodies[0].shape).size.x = 42 * spacing; },
          "it has 42 particles along x, which must be a multiple of 8; make it 0.09375 m long");
  refused([](Setup& s) { s.bodies[0].holes = {{.name = "hole", .shape = BoxSolid{{0.01, 0.01, 0.01}}}}; }, "it does not fill a box");
  refused([](Setup& s) { s.bodies[0].failure = FailureSetup{.weibull_modulus = 8}; }, "its strength is scattered");
  refused([](Setup& s) { s.bodies[0].velocity = {1, 0, 0}; }, "it has an initial velocity");
  refused(
      [](Setup& s) {
        s.bodies[0].cracks = {{"notch", {{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}}}};
      },
      "it has initial cracks, which material added later lacks");
  refused([](Setup& s) { s.output.probes = {{"end", "body", {}}}; }, "probes and lines refer to points of it");
  refused([](Setup& s) { s.bodies[0].boundary_conditions = {{"push", BodyForceSetup{}}}; }, "push is none of fixed, absorbing and floating");
  refused(
      [](Setup& s) {
        FloatingSetup part;
        part.particle_set = "part", part.level = 0;
        s.bodies[0].particle_sets = {{.name = "part", .shape = BoxSolid{{0.01, 1, 1}}}};
        s.bodies[0].boundary_conditions = {{"sea", part}};
      },
      "boundary condition sea floats a part of it; float all of it");
}
