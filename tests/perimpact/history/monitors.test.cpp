#include "perimpact/history/monitors.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::value;

namespace {

/// A block of 4 × 4 × 4 cm in contact with a face wider than itself, for 600 steps.
Setup impacted_block(std::optional<double> history) {
  Setup setup;
  setup.time = {.end = 600 * 4e-7, .step = 4e-7};
  BodySetup block = fixtures::body_setup({.size = {0.04, 0.04, 0.04}, .spacing = 0.01});
  block.name = "block";
  setup.bodies = {block};
  ImpactorSetup hammer;
  hammer.name = "hammer";
  hammer.surface = BoxSurface{.size = {0.06, 0.02, 0.06}, .edge_length = 0.01};
  hammer.mass = 0.2;
  hammer.position = {0, 0.0301, 0};
  hammer.velocity = {0, -5, 0};
  hammer.free_dofs = {"y"};
  setup.impactors = {hammer};
  setup.output.history_interval = history;
  return setup;
}

/// Makes a body much faster, as an unstable step would.
void give_energy(Simulation& simulation) {
  simulation.visit_state([](std::string_view name, auto&& values) {
    if constexpr (std::is_same_v<typename decltype(fccda::numbers_in(values))::value_type, double>)
      if (name.starts_with("block") && name.find(".velocity_") != std::string_view::npos)
        for (double& one : fccda::numbers_in(values)) one = 10 * one + 1;
  });
}

}  // namespace

TEST_CASE("monitors: energy without a source is detected at the same step, with the same message, for any output.history_interval") {
  std::vector<std::string> sentences;
  for (const std::optional<double> history : {std::optional<double>(), std::optional(4e-7), std::optional(28e-7), std::optional(1.0)}) {
    Simulation simulation(impacted_block(history));
    while (simulation.clock().step < 301) simulation.step();
    give_energy(simulation);
    try {
      fixtures::run(simulation);
    } catch (const fccda::RunError& error) {
      sentences.emplace_back(error.what());
    }
    CHECK(simulation.clock().step == 306);  // every hundredth of the run is checked, here every sixth step
  }
  REQUIRE(sentences.size() == 4);
  for (const std::string& one : sentences) CHECK(one == sentences.front());
}

TEST_CASE("monitors: output.history_interval changes neither the state nor the largest pressure of any panel") {
  std::vector<double> pressure;
  std::uint64_t hash = 0;
  for (const double history : {4e-7, 28e-7, 1.0}) {
    Simulation simulation(impacted_block(history));
    fixtures::run(simulation);
    const std::span<const double> peak = simulation.impactors()[0].record().panels().peak_pressure();
    if (pressure.empty()) {
      pressure.assign(peak.begin(), peak.end());
      hash = simulation.state_hash();
    }
    CHECK(*std::max_element(peak.begin(), peak.end()) > 0);
    CHECK(std::equal(peak.begin(), peak.end(), pressure.begin(), pressure.end()));
    CHECK(simulation.state_hash() == hash);
  }
}

TEST_CASE("monitors: creating a row does not change the state, and interval means add up to the ledgers") {
  Simulation often(impacted_block(4e-7)), seldom(impacted_block(1.0));
  double impulse = 0;
  while (!often.clock().is_finished()) {
    often.step(), seldom.step();
    impulse += value(often, "hammer.force_y [N]") * often.clock().dt;
  }
  CHECK(often.impactors()[0].account().impulse.y == seldom.impactors()[0].account().impulse.y);
  CHECK(impulse == fixtures::relative(often.impactors()[0].account().impulse.y, 1e-12));  // 600 differences of sums, each rounded at 1e-16
  CHECK(value(seldom, "hammer.force_y [N]") * seldom.clock().time() == fixtures::relative(often.impactors()[0].account().impulse.y, 1e-12));
}

TEST_CASE("monitors: each column has a kind, a unit and a meaning, forces are interval means, works cumulative") {
  const Simulation simulation(impacted_block({}));
  for (const Column& column : simulation.monitors().columns()) {
    CHECK_FALSE(column.unit.empty());
    CHECK_FALSE(column.meaning.empty());
    const std::string_view quantity = std::string_view(column.name).substr(column.name.rfind('.') + 1);
    if (quantity.starts_with("force_") || quantity.starts_with("moment_")) CHECK(column.kind == ColumnKind::interval_mean);
    if (quantity.ends_with("_work")) CHECK(column.kind == ColumnKind::cumulative);
    if (quantity.starts_with("position_") || quantity.starts_with("momentum_")) CHECK(column.kind == ColumnKind::instantaneous);
  }
}
