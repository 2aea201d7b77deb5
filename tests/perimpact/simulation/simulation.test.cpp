#include "perimpact/simulation/simulation.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::complaint;
using fixtures::run;
using fixtures::value;

namespace {

/// A small plate with a cylinder in contact with its edge at t = 0.
Setup impacted_plate(double nu = 0.25) {
  Setup setup;
  setup.time = {.end = 40e-6, .step = 2e-7};
  BodySetup plate = fixtures::body_setup({.size = {0.04, 0.02, 0.008}, .spacing = 0.002, .poissons_ratio = nu});
  plate.name = "plate";
  setup.bodies = {plate};
  ImpactorSetup cylinder;
  cylinder.name = "cylinder";
  cylinder.surface = CylinderSurface{.diameter = 0.02, .height = 0.02, .edge_length = 0.001};
  cylinder.mass = 0.1;
  cylinder.position = {0.003, 0.02, 0};
  cylinder.velocity = {0, -32, 0};
  cylinder.free_dofs = {"x", "y", "z", "rx", "ry", "rz"};
  setup.impactors = {cylinder};
  setup.output.history_interval = 2e-6;
  setup.output.probes = {{"centre", "plate", {0, 0, 0}}};
  return setup;
}

}  // namespace

TEST_CASE("simulation: the stages of its set-up are announced when they begin, and timed") {
  std::vector<std::string> announced;
  const Simulation simulation(impacted_plate(), [&](std::string_view stage, std::string_view of) {
    announced.push_back(of.empty() ? std::string(stage) : fmt::format("{} of {}", stage, of));
  });
  CHECK(announced == std::vector<std::string>{"solids and points of plate", "surfaces of cylinder", "particles of plate", "detectors of cylinder",
                                              "initial overlap", "bonds of plate", "surface correction of plate", "initial cracks of plate",
                                              "contact of fragments", "time step", "diagnostics", "initial forces"});
  REQUIRE(simulation.set_up_timers().rows().size() == announced.size());
  for (std::size_t stage = 0; stage < announced.size(); ++stage) {
    CHECK(announced[stage].starts_with(simulation.set_up_timers().rows()[stage].name));
    CHECK(simulation.set_up_timers().rows()[stage].seconds > 0);
  }
}

TEST_CASE("simulation: plate and cylinder conserve their linear momentum to 1e-10, in off-centre impact with free rotation") {
  for (const double friction : {0.0, 0.2}) {
    Setup setup = impacted_plate();
    setup.contact.impactors.friction = friction;
    Simulation simulation(setup);
    const double before = value(simulation, "total.momentum_y [kg m/s]");
    run(simulation);
    CHECK(before == fixtures::relative(-3.2, 1e-12));  // 0.1 kg at 32 m/s
    CHECK(std::fabs(value(simulation, "total.momentum_y [kg m/s]") / before - 1) <= 1e-10);
    CHECK(std::fabs(value(simulation, "total.momentum_x [kg m/s]")) <= 1e-10 * 3.2);
    CHECK(std::fabs(value(simulation, "cylinder.velocity_y [m/s]")) < 30);  // contact occurred
  }
}

TEST_CASE("simulation: one, two and four threads end in the bitwise identical state, with a dilatation, breaking bonds and a rotating impactor") {
  Setup setup = impacted_plate(0.3);
  std::get<OrdinaryStateSetup>(setup.bodies[0].material).critical_stretch = 2e-3;
  setup.impactors[0].angular_velocity = {0, 0, 100};
  setup.contact.impactors.friction = 0.1;
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    const fixtures::Threads with_several(threads);
    Simulation simulation(setup);
    const std::uint64_t at_start = simulation.state_hash();
    run(simulation);
    hashes.push_back(simulation.state_hash());
    CHECK(hashes.back() != at_start);
    CHECK(value(simulation, "plate.broken_bonds [-]") > 0);
  }
  CHECK(hashes[0] == hashes[1]);
  CHECK(hashes[0] == hashes[2]);
}

TEST_CASE("simulation: the hash detects a single changed bit of the state") {
  Simulation simulation(impacted_plate());
  const std::uint64_t hash = simulation.state_hash();
  std::span<double> velocity;
  simulation.visit_state([&](const std::string& name, auto&& values) {
    if constexpr (std::is_base_of_v<std::span<double>, std::remove_cvref_t<decltype(values)>>)
      if (name == "plate.velocity_z") velocity = values;
  });
  velocity[17] = 5e-324;  // the smallest positive number, in place of 0
  CHECK(simulation.state_hash() != hash);
}

TEST_CASE("simulation: a fine mesh and the analytic cylinder agree within three times the facet error") {
  Setup meshed = impacted_plate(), analytic = impacted_plate();
  for (Setup* setup : {&meshed, &analytic}) setup->impactors[0].position.x = 0, setup->impactors[0].free_dofs = {"y"};
  analytic.contact.impactors.detector.index = static_cast<int>(DetectorKind::analytic);
  Simulation a(meshed), b(analytic);
  run(a), run(b);
  const double facet = 0.001 * 0.001 / (8 * 0.01);  // Δm²/(8R)
  CHECK(std::fabs(value(a, "centre.displacement_y [m]") - value(b, "centre.displacement_y [m]")) <= 3 * facet);
  CHECK(std::fabs(value(a, "cylinder.position_y [m]") - value(b, "cylinder.position_y [m]")) <= 3 * facet);
  CHECK(std::fabs(value(a, "centre.displacement_y [m]")) > 10 * facet);
}

TEST_CASE("simulation: contact bounds exactly as wide as the cylinder change no force") {
  Setup without = impacted_plate(), with = impacted_plate();
  with.impactors[0].contact_bounds = {BoxRegionSetup{.size = {0.02, 0.02, 0.01}}, Choice{on_exceed_words, 1}};
  Simulation a(without), b(with);
  while (!a.clock().is_finished()) {
    a.step(), b.step();
    // the plate is thinner than the bounds, so that no contact is clipped: bitwise the same contacts
    REQUIRE(std::ranges::equal(a.monitors().row(), b.monitors().row()));
  }
  CHECK(a.impactors()[0].account().impulse.y > 0);
  CHECK(a.state_hash() == b.state_hash());
}

TEST_CASE("simulation: an unstable step and an impactor that starts inside are refused with their key") {
  std::string key;
  Setup too_long = impacted_plate();
  too_long.time.step = 2e-6;
  CHECK(complaint(too_long, key).find("times the critical time step") != std::string::npos);
  CHECK(key == "time.step");
  Setup inside = impacted_plate();
  inside.impactors[0].position.y = 0.018;
  CHECK(complaint(inside, key).find("starts inside body plate") != std::string::npos);
  CHECK(key == "impactors.cylinder.position");
}

TEST_CASE("simulation: constrained degrees of freedom keep their velocity, and constraint work balances the energy") {
  Setup setup = impacted_plate();
  setup.impactors[0].free_dofs = {};
  setup.impactors[0].position.x = 0;
  Simulation simulation(setup);
  run(simulation);
  CHECK(value(simulation, "cylinder.velocity_y [m/s]") == -32);
  const double work = simulation.impactors()[0].constraint_work();
  CHECK(work > 0);
  // relocation is plastic, so that a little work is dissipated at first contact; none may be created
  const double gained = value(simulation, "total.energy [J]") - 0.5 * 0.1 * 32 * 32;
  CHECK(gained <= 1.01 * work);
  CHECK(gained >= 0.8 * work);
}

TEST_CASE("simulation: an energy increase without a source ends the run with a message") {
  Simulation simulation(impacted_plate());
  for (int step = 0; step < 20; ++step) simulation.step();
  simulation.visit_state([&](const std::string& name, auto&& values) {  // what an unstable step would do
    if constexpr (std::is_base_of_v<std::span<double>, std::remove_cvref_t<decltype(values)>>)
      if (name.find("plate.velocity") != std::string::npos)
        for (double& one : values) one *= 30;
  });
  std::string sentence;
  try {
    run(simulation);
  } catch (const fccda::RunError& error) {
    sentence = error.what();
  }
  CHECK(sentence.find("is unstable for this run; reduce it") != std::string::npos);
}
