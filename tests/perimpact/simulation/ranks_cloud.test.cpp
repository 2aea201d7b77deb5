#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

#include "perimpact/fragments/fragments.hpp"
#include "perimpact/rank_scenes.hpp"
#include "perimpact/rank_traces.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;

namespace {

void expect_equal_and_broken(const Setup& setup) {
  const fixtures::Trace one = fixtures::expect_equal_on_ranks(setup);
  CHECK(one.broken_bonds > 20);
}

}  // namespace

TEST_CASE("ranks: point clouds of every material that break under a free impactor with friction are bitwise those of one rank") {
  for (const fixtures::Model model :
       {fixtures::Model::ordinary_state, fixtures::Model::linear_solid, fixtures::Model::bond_based, fixtures::Model::correspondence})
    for (const Plane plane : {Plane::none, Plane::strain}) {
      if (model == fixtures::Model::bond_based && plane != Plane::none) continue;  // has no plane strain at this Poisson's ratio
      CAPTURE(static_cast<int>(model));
      expect_equal_and_broken(fixtures::scattered(fixtures::struck_plate({.critical_stretch = 2e-3, .model = model, .plane = plane})));
    }
}

TEST_CASE("ranks: point clouds whose bonds are stronger under compression or scattered in strength, or that yield, are bitwise those of one rank") {
  FailureSetup hardening, weibull;
  hardening.compression_hardening = 0.3;
  weibull.weibull_modulus = 8;
  for (const FailureSetup& failure : {hardening, weibull})
    expect_equal_and_broken(fixtures::scattered(fixtures::struck_plate({.critical_stretch = 2e-3, .failure = failure})));
  Setup yielding = fixtures::scattered(fixtures::struck_plate({.poissons_ratio = 0.3, .critical_stretch = 4e-3}));
  std::get<OrdinaryStateSetup>(yielding.bodies[0].material).plasticity.emplace().compressive_strength = 400e6;
  expect_equal_and_broken(yielding);
}

TEST_CASE("ranks: contact between fragments of point clouds is that of one rank") {
  for (const Plane plane : {Plane::none, Plane::strain})
    expect_equal_and_broken(fixtures::scattered(fixtures::rubble({.critical_stretch = 2e-3, .plane = plane})));
}

TEST_CASE("ranks: a point cloud continues bitwise from the state of another number of ranks, and its fragments have the masses of one rank") {
  const Setup setup = fixtures::scattered(fixtures::rubble({.critical_stretch = 2e-3}));
  std::uint64_t expected = 0;
  std::vector<double> masses;
  for (const int from : {1, 3}) {
    fixtures::WholeState state;
    run_in_process(from, [&](Ranks& its) {
      Simulation simulation(setup, {}, its);
      while (simulation.clock().step < simulation.clock().steps / 2) simulation.step();
      const fixtures::WholeState all = fixtures::state_of_all_ranks(simulation);
      if (its.is_root()) state = all;
    });
    for (const int ranks : {1, 2, 5}) {
      CAPTURE(from);
      CAPTURE(ranks);
      run_in_process(ranks, [&](Ranks& its) {
        Simulation simulation(setup, {}, its);
        fixtures::take(simulation, state);
        fixtures::run(simulation);
        const std::uint64_t hash = simulation.state_hash();
        const Body& plate = simulation.bodies()[0];
        std::vector<double> its_masses;
        const Fragments fragments(plate.particles, plate.family);
        for (const Fragment& fragment : fragments.all()) its_masses.push_back(fragment.mass);
        if (!its.is_root()) return;
        if (masses.empty()) expected = hash, masses = its_masses;
        CHECK(hash == expected);
        CHECK(its_masses == masses);
      });
    }
  }
  CHECK(masses.size() > 3);
  CHECK(expected == fixtures::trace(setup, 1).hashes.back());
}

TEST_CASE("ranks: bodies divided by the load that was measured in another run, lattices and clouds, end in the state of one rank") {
  const Setup lattices = fixtures::rubble({.critical_stretch = 2e-3}), clouds = fixtures::scattered(lattices);
  for (const Setup* setup : {&lattices, &clouds}) {
    const std::uint64_t expected = fixtures::trace(*setup, 1).hashes.back();
    std::vector<MeasuredLoad> loads;
    run_in_process(3, [&](Ranks& its) {  // as measured, if the first rank were four times as slow
      const Simulation simulation(*setup, {}, its);
      if (!its.is_root()) return;
      for (const Body& body : simulation.bodies()) {
        MeasuredLoad& load = loads.emplace_back();
        for (int rank = 0; rank < 3; ++rank) load.push_back({body.particles.share().part_of(rank), rank == 0 ? 4.0 : 1.0});
      }
    });
    for (const int ranks : {2, 3, 7}) {
      CAPTURE(ranks);
      run_in_process(ranks, [&](Ranks& its) {
        const Simulation equal(*setup, {}, its);
        Simulation simulation(*setup, {}, its, loads);
        const auto plate_of = [](const Simulation& of) { return static_cast<std::int64_t>(of.bodies()[0].particles.size()); };
        const bool is_other = its.any(plate_of(equal) != plate_of(simulation));
        fixtures::run(simulation);
        const std::uint64_t hash = simulation.state_hash();
        if (!its.is_root()) return;
        CHECK(is_other);
        CHECK(hash == expected);
      });
    }
  }
}
