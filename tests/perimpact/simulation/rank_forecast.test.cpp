#include "perimpact/simulation/rank_forecast.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <mutex>
#include <sstream>
#include <string>

#include "fixtures/larger.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/elastic_modes.hpp"
#include "perimpact/particles/share.hpp"
#include "perimpact/rank_scenes.hpp"
#include "perimpact/ranks/counting_ranks.hpp"
#include "perimpact/ranks/in_process.hpp"
#include "perimpact/simulation/memory.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;

namespace {

constexpr int counts[] = {2, 3, 8};

/// A body at rest, in so many steps that the first ones are not sampled for the history.
Setup at_rest(const BodySetup& body) {
  Setup setup;
  setup.time = {.end = 1e-2, .step = 1e-8};
  setup.bodies = {body};
  return setup;
}

BodySetup plate(fixtures::BodyOptions options) {
  options.size = {0.068, 0.042, options.plane == Plane::none ? 0.010 : 0.002}, options.spacing = 0.002;
  return fixtures::body_setup(options);
}

std::vector<Discretisation> discretised(const Setup& setup) {
  std::vector<Discretisation> bodies;
  for (const BodySetup& body : setup.bodies) bodies.push_back(discretise(body));
  return bodies;
}

/// Every material, with and without failure.
std::map<std::string, BodySetup> materials() {
  std::map<std::string, BodySetup> bodies;
  for (const bool fails : {false, true}) {
    const auto critical = fails ? std::optional(1e-2) : std::nullopt;
    const std::string suffix = fails ? ", fails" : "";
    bodies["bond-based" + suffix] = plate({.critical_stretch = critical, .model = fixtures::Model::bond_based});
    bodies["linear solid" + suffix] = plate({.poissons_ratio = 0.3, .critical_stretch = critical, .model = fixtures::Model::linear_solid});
    for (const double nu : {0.25, 0.3}) {
      const std::string name = "ordinary state, nu " + std::to_string(nu) + suffix;
      bodies[name] = plate({.poissons_ratio = nu, .critical_stretch = critical});
      bodies[name + ", plastic"] = bodies[name];
      std::get<OrdinaryStateSetup>(bodies[name + ", plastic"].material).plasticity.emplace().compressive_strength = 400e6;
    }
    for (const Plane plane : {Plane::none, Plane::strain})
      for (const Stabilisation stabilisation : {Stabilisation::bond_level, Stabilisation::wan})
        bodies["correspondence " + std::to_string(static_cast<int>(stabilisation)) + (plane == Plane::none ? "" : ", plane") + suffix] =
            plate({.critical_stretch = critical, .model = fixtures::Model::correspondence, .stabilisation = stabilisation, .plane = plane});
  }
  FailureSetup hardening;
  hardening.compression_hardening = 0.3;
  bodies["hardening"] = plate({.critical_stretch = 1e-2, .failure = hardening});
  return bodies;
}

/// A body with every boundary condition, some of them without effect in the water.
std::map<std::string, BodySetup> constrained() {
  BodySetup body = plate({.model = fixtures::Model::bond_based});
  SolidSetup left, right;
  left.name = "left", left.shape = BoxSolid{{0.014, 1, 1}}, left.position = {-0.027, 0, 0};
  right.name = "right", right.shape = BoxSolid{{0.014, 1, 1}}, right.position = {0.027, 0, 0};
  body.particle_sets = {left, right};
  DisplacementSetup up;
  up.displacement = 2e-5;
  AbsorbingSetup end;
  end.particle_set = "right", end.face = Choice{face_words, 0};
  FloatingSetup water, dry, plain;
  water.drag = 1, water.level = 0, dry.drag = 0, dry.dry_top = 0.001, dry.level = 0, dry.particle_set = "left", plain.drag = 0, plain.level = 0;
  const std::pair<std::string, BoundaryConditionKind> all[] = {{"fixed", FixedSetup{.particle_set = "left"}},
                                                               {"prescribed", PrescribedSetup{.particle_set = "left", .y = up}},
                                                               {"pressure", PressureSetup{.face = Choice{face_words, 0}, .value = 2e3}},
                                                               {"body force", BodyForceSetup{.force_density = {0, 0, 1}}},
                                                               {"absorbing", end},
                                                               {"floating, drag", water},
                                                               {"floating, dry top of a part", dry},
                                                               {"floating", plain}};
  std::map<std::string, BodySetup> bodies;
  for (const auto& [name, kind] : all) {
    bodies[name] = body;
    bodies[name].boundary_conditions = {{"one", kind}};
  }
  bodies["several"] = body;
  bodies["several"].boundary_conditions = {{"grip", all[0].second}, {"push", all[2].second}, {"water", water}};
  return bodies;
}

ImpactorSetup ball(const std::string& name, const Vec3d& position) {
  ImpactorSetup impactor;
  impactor.name = name;
  impactor.surface = SphereSurface{.diameter = 0.02, .edge_length = 0.004};
  impactor.mass = 1;
  impactor.position = position;
  return impactor;
}

/// What each rank sends in so many steps.
std::vector<Traffic> sent_in(const Setup& setup, int ranks, int steps) {
  std::vector<Traffic> sent(static_cast<std::size_t>(ranks));
  run_in_process(ranks, [&](Ranks& inner) {
    CountingRanks counting(inner);
    Simulation simulation(setup, {}, counting);
    for (int step = 0; step < steps; ++step) simulation.step();
    sent[static_cast<std::size_t>(inner.rank())] = simulation.traffic_of_steps();
  });
  return sent;
}

/// Whether the forecast is what the ranks send in two steps, which are not sampled.
void check_steps(const Setup& setup) {
  for (const int ranks : counts) {
    CAPTURE(ranks);
    const RankForecast forecast = rank_forecast_of(setup, discretised(setup), ranks, 0, {});
    const std::vector<Traffic> sent = sent_in(setup, ranks, 2);
    for (std::size_t rank = 0; rank < sent.size(); ++rank) {
      const Traffic& expected = forecast.sent[rank];
      CAPTURE(rank);
      CHECK(expected.bytes > 0);
      CHECK(sent[rank].messages == 2 * expected.messages);
      CHECK(sent[rank].bytes == 2 * expected.bytes);
      CHECK(sent[rank].reductions == 2 * expected.reductions);
      CHECK(sent[rank].reduced_bytes == 2 * expected.reduced_bytes);
      CHECK(sent[rank].collections == 2 * expected.collections);
    }
  }
}

std::vector<BodyShare> shares_of(const BodySetup& body, int ranks) {
  RanksInTurn in_turn(ranks);
  return shares_of_ranks(body, discretise(body), in_turn);
}

}  // namespace

TEST_CASE("rank forecast: messages, bytes and reductions of a step are exactly those that every rank sends, for every material") {
  for (const auto& [name, body] : materials()) {
    CAPTURE(name);
    check_steps(at_rest(body));
  }
}

TEST_CASE("rank forecast: messages, bytes and reductions of a step are exactly those that every rank sends, for point clouds of every material") {
  for (const auto& [name, body] : materials()) {
    CAPTURE(name);
    check_steps(fixtures::scattered(at_rest(body)));
  }
}

TEST_CASE("rank forecast: messages, bytes and reductions of a step are exactly those that every rank sends, for every boundary condition") {
  for (const auto& [name, body] : constrained()) {
    CAPTURE(name);
    check_steps(at_rest(body));
  }
}

TEST_CASE(
    "rank forecast: messages, bytes and reductions of a step are exactly those that every rank sends, for two bodies and one or two impactors, also elastic") {
  Setup setup = at_rest(plate({.poissons_ratio = 0.3}));
  BodySetup second = plate({.model = fixtures::Model::bond_based});
  second.name = "second", second.position = {0, 0.1, 0};
  setup.bodies.push_back(second);
  setup.impactors = {ball("one", {0, 0, 0.1})};
  check_steps(setup);
  setup.impactors.push_back(ball("two", {0, 0, -0.1}));
  check_steps(setup);
  const ::fixtures::TemporaryFolder folder;
  fixtures::make_elastic(setup.impactors[1], folder / "modes.csv");
  check_steps(setup);
}

TEST_CASE("rank forecast: messages and bytes of a run with contact, bonds that break and rows of history are those of its steps") {
  for (const double nu : {0.25, 0.3}) {
    Setup setup = at_rest(plate({.poissons_ratio = nu, .critical_stretch = 2e-3}));
    setup.time = {.end = 12e-6, .step = 2e-7};
    setup.impactors = {ball("ball", {0.003, 0, 0.0151})};
    setup.impactors[0].velocity = {0, 0, -200};
    setup.impactors[0].free_dofs = {"z"};
    for (const int ranks : counts) {
      CAPTURE(ranks);
      const RankForecast forecast = rank_forecast_of(setup, discretised(setup), ranks, 0, {});
      const std::vector<Traffic> sent = sent_in(setup, ranks, 60);
      std::int64_t collected = 0;
      for (std::size_t rank = 0; rank < sent.size(); ++rank) {
        CHECK(sent[rank].messages == 60 * forecast.sent[rank].messages);
        CHECK(sent[rank].bytes == 60 * forecast.sent[rank].bytes);
        CHECK(sent[rank].reductions > 60 * forecast.sent[rank].reductions);
        collected += sent[rank].collected_bytes;
      }
      CHECK(collected > 0);  // contacts
    }
  }
}

TEST_CASE("rank forecast: while material yields, plastic strain and its flow are refreshed in addition, 15 numbers of each ghost at a time") {
  Setup setup = at_rest(plate({.poissons_ratio = 0.25}));
  std::get<OrdinaryStateSetup>(setup.bodies[0].material).plasticity.emplace().compressive_strength = 400e6;
  setup.time = {.end = 6e-6, .step = 2e-7};
  setup.impactors = {ball("ball", {0.003, 0, 0.0151})};
  setup.impactors[0].velocity = {0, 0, -200};
  const std::vector<BodyShare> shares = shares_of(setup.bodies[0], 3);
  const RankForecast forecast = rank_forecast_of(setup, discretised(setup), 3, 0, {});
  const std::vector<Traffic> sent = sent_in(setup, 3, 30);
  for (std::size_t rank = 0; rank < sent.size(); ++rank) {
    const std::int64_t refreshed = (sent[rank].messages - 30 * forecast.sent[rank].messages) / static_cast<std::int64_t>(shares[rank].neighbours);
    CHECK(refreshed > 10);
    CHECK(sent[rank].bytes - 30 * forecast.sent[rank].bytes == refreshed * 15 * 8 * static_cast<std::int64_t>(shares[rank].sent_slots));
  }
}

TEST_CASE("rank forecast: shares, ghosts and neighbours are those of the ranks of a run") {
  const BodySetup body = plate({});
  const Lattice whole = lattice_that_fills(body, BodySolid(body));
  const PartitionRule rule = partition_rule_of(body, whole);
  for (const int ranks : {1, 2, 7, 8}) {
    CAPTURE(ranks);
    const std::vector<BodyShare> shares = shares_of(body, ranks);
    std::mutex mutex;
    run_in_process(ranks, [&](Ranks& its) {
      const Share share(its, whole, rule);
      const BodyShare& forecast = shares[static_cast<std::size_t>(its.rank())];
      const std::lock_guard guard(mutex);
      CHECK(forecast.neighbours == share.peers());
      CHECK(forecast.ghosts == static_cast<double>(share.ghosts()));
      CHECK(forecast.sent_slots == static_cast<double>(share.sent_slots()));
      if (ranks > 1) CHECK(forecast.cells == static_cast<double>(share.owned_cells().cells()));
      if (ranks > 1) CHECK(forecast.slots == fixtures::relative(static_cast<double>(share.lattice().slots()) / static_cast<double>(whole.slots()), 1e-12));
    });
  }
}

TEST_CASE("rank forecast: shares, ghosts and neighbours in a point cloud are those of the ranks of a run") {
  const Setup setup = fixtures::scattered(at_rest(plate({})));
  const BodySetup& body = setup.bodies[0];
  const Discretisation discretisation = discretise(body);
  const Cloud& cloud = std::get<Cloud>(discretisation);
  for (const int ranks : {2, 7, 8}) {
    CAPTURE(ranks);
    const std::vector<BodyShare> shares = shares_of(body, ranks);
    std::mutex mutex;
    run_in_process(ranks, [&](Ranks& its) {
      const Particles particles = make_particles(body, discretisation, its);
      const Share& share = particles.share();
      const BodyShare& forecast = shares[static_cast<std::size_t>(its.rank())];
      const std::lock_guard guard(mutex);
      CHECK(forecast.cells == static_cast<double>(particles.size()));
      CHECK(forecast.neighbours == share.peers());
      CHECK(forecast.ghosts == static_cast<double>(share.ghosts()));
      CHECK(forecast.sent_slots == static_cast<double>(share.sent_slots()));
      CHECK(forecast.slots ==
            fixtures::relative(static_cast<double>(particles.slots()) / (8 * std::ceil(static_cast<double>(cloud.points.size()) / 8)), 1e-12));
    });
  }
}

TEST_CASE("rank forecast: a rank needs its share of the memory of all particles, also of what impactors keep of them, but every surface and the program") {
  Setup setup = at_rest(plate({.critical_stretch = 1e-2}));
  setup.impactors = {ball("one", {0, 0, 0.1})};
  const std::vector<Discretisation> bodies = discretised(setup);
  const Memory whole = memory_of(setup, bodies);
  const Impactor impactor(setup.impactors[0], setup.contact.impactors, {});
  Memory with_surface = whole;
  with_surface.add(impactor.surface());
  const double program = 21e6, of_surface = with_surface.of_surfaces[0].bytes;
  Memory half = with_surface;
  half.reduce_to(0.5);
  CHECK(whole.at_rest > program + whole.of_bodies[0]);  // what the impactor keeps
  CHECK(half.at_rest == fixtures::relative(program + of_surface + 0.5 * (whole.at_rest - program), 1e-12));
  CHECK(half.of_bodies[0] == fixtures::relative(0.5 * whole.of_bodies[0], 1e-12));
}

TEST_CASE("rank forecast: the duration of a step is that of the slowest rank by the model") {
  const Setup setup = at_rest(plate({.poissons_ratio = 0.3}));
  const Network network{.latency = 1e-3, .bandwidth = 1e6};
  const RankForecast forecast = rank_forecast_of(setup, discretised(setup), 4, 10, network);
  double slowest = 0;
  for (const BodyShare& share : shares_of(setup.bodies[0], 4))  // 48 bytes and 8 bytes of each cell
    slowest = fixtures::larger(slowest, 10 * share.cells / forecast.cells[0] + 2 * static_cast<double>(share.neighbours) * 1e-3 + 56 * share.sent_slots / 1e6);
  CHECK(forecast.step() == fixtures::relative(slowest, 1e-12));
  Setup held = setup;
  held.bodies[0].boundary_conditions = {{"grip", BodyForceSetup{.force_density = {0, 0, 1}}}};  // a reduction of three exact sums, in two rounds
  CHECK(rank_forecast_of(held, discretised(held), 4, 10, network).step() - forecast.step() == fixtures::relative(2 * (1e-3 + 3 * 70 * 8 / 1e6), 1e-9));
}

TEST_CASE("rank forecast: small bodies are divided among the ranks in turn, and more ranks than these have blocks of cells are refused as in the run") {
  Setup setup;
  setup.time = {.end = 1e-6, .step = 1e-8};
  for (const char* name : {"one", "two"}) {
    BodySetup body = fixtures::body_setup({.size = {0.008, 0.003, 0.001}, .spacing = 0.001});
    body.name = name;
    setup.bodies.push_back(body);
  }
  setup.bodies[1].position = {0, 0.1, 0};
  RanksInTurn in_turn(5);
  const std::vector<BodyShare> one = shares_of_ranks(setup.bodies[0], discretise(setup.bodies[0]), in_turn),
                               two = shares_of_ranks(setup.bodies[1], discretise(setup.bodies[1]), in_turn);
  for (std::size_t rank = 0; rank < 5; ++rank) {
    CHECK(one[rank].cells == (rank < 3 ? 8 : 0));
    CHECK(two[rank].cells == (rank >= 3 || rank == 0 ? 8 : 0));
  }
  CHECK(rank_forecast_of(setup, discretised(setup), 6, 0, {}).cells == std::vector<double>{24, 24});
  const auto refusal = [](const auto& use) {
    try {
      use();
    } catch (const SetupError& error) {
      return error.key() + ": " + error.what();
    }
    return std::string();
  };
  const std::string forecast = refusal([&] { rank_forecast_of(setup, discretised(setup), 7, 0, {}); });
  CHECK(forecast ==
        "bodies: 7 ranks are too many: the bodies can be divided among at most 6, since lattices are cut across x at multiples of eight cells only, "
        "and point clouds between blocks of eight particles. Use fewer.");
  CHECK(refusal([&] { run_in_process(7, [&](Ranks& its) { Simulation(setup, {}, its); }); }) == forecast);
}
