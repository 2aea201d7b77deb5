#include <doctest/doctest.h>

#include <cstring>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "perimpact/bodies.hpp"
#include "perimpact/rank_scenes.hpp"
#include "perimpact/rank_traces.hpp"
#include "perimpact/ranks/in_process.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;

namespace {

/// The state of a body by slot of its whole lattice, whatever the number of ranks that computed it.
struct WholeBody {
  std::map<std::string, std::vector<double>> values;  // of each slot
  std::vector<std::uint8_t> bonds;                    // of each slot, one byte per bond of the stencil

  bool operator==(const WholeBody&) const = default;
};

struct Whole {
  std::vector<WholeBody> bodies;
  std::vector<double> impactors;  // positions, velocities and ledgers
  std::size_t contacts = 0;
  std::uint64_t hash = 0;
  std::vector<double> row;  // the last of the history
  std::map<std::string, std::size_t> columns;
};

void add_state(const Simulation& simulation, Whole& whole, std::mutex& mutex) {
  const std::lock_guard guard(mutex);
  whole.bodies.resize(simulation.bodies().size());
  for (std::size_t b = 0; b < whole.bodies.size(); ++b) {
    const Body& body = simulation.bodies()[b];
    const std::size_t slots = body.particles.whole_lattice()->slots(), bonds = body.family.stencil()->size();
    WholeBody& its = whole.bodies[b];
    its.bonds.resize(slots * bonds, 2);
    const auto put = [&](const std::string& name, std::size_t slot, double value) {
      its.values[name].resize(slots, -1e300);
      its.values[name][body.particles.share().whole_slot(slot)] = value;
    };
    for (const std::uint32_t slot : body.particles.slot_of()) {
      for (std::size_t c = 0; c < 3; ++c) {
        put("x" + std::to_string(c), slot, body.particles.position.at(slot)[c]);
        put("v" + std::to_string(c), slot, body.particles.velocity.at(slot)[c]);
        put("f" + std::to_string(c), slot, body.particles.force_density.at(slot)[c]);
      }
      if (const PlasticForce* plastic = body.internal.plastic()) put("plastic", slot, plastic->equivalent_strain(slot));
      for (std::size_t r = 0; r < bonds; ++r)
        its.bonds[body.particles.share().whole_slot(slot) * bonds + r] = (body.family.bytes(slot / 8)[r] >> (slot % 8)) & 1u;
    }
  }
  if (!simulation.ranks().is_root()) return;
  for (const Impactor& impactor : simulation.impactors()) {
    const auto put = [&](const Vec3d& v) { whole.impactors.insert(whole.impactors.end(), {v.x, v.y, v.z}); };
    put(impactor.body().position_of_com()), put(impactor.body().velocity()), put(impactor.body().angular_velocity());
    put(impactor.account().impulse), put(impactor.account().angular_impulse);
    whole.impactors.insert(whole.impactors.end(), {impactor.contact_work(), impactor.work_on_particles()});
  }
  whole.contacts = simulation.contacts();
  whole.row.assign(simulation.monitors().row().begin(), simulation.monitors().row().end());
  for (const Column& column : simulation.monitors().columns()) whole.columns.emplace(column.heading(), whole.columns.size());
}

Whole after(const Setup& setup, int ranks) {
  Whole whole;
  std::mutex mutex;
  run_in_process(ranks, [&](Ranks& its) {
    Simulation simulation(setup, {}, its);
    fixtures::run(simulation);
    add_state(simulation, whole, mutex);
    const std::uint64_t hash = simulation.state_hash();
    if (its.is_root()) whole.hash = hash;
  });
  return whole;
}

void check_equal(const Whole& a, const Whole& b) {
  REQUIRE(a.bodies.size() == b.bodies.size());
  for (std::size_t body = 0; body < a.bodies.size(); ++body) {
    for (const auto& [name, values] : a.bodies[body].values) {
      CAPTURE(name);
      CHECK(std::memcmp(values.data(), b.bodies[body].values.at(name).data(), values.size() * sizeof(double)) == 0);
    }
    CHECK(a.bodies[body].bonds == b.bodies[body].bonds);
  }
  CHECK(a.impactors == b.impactors);
  CHECK(a.contacts == b.contacts);
  CHECK(a.hash == b.hash);
  CHECK(a.row == b.row);
}

constexpr int counts[] = {2, 3, 4, 7, 8};
constexpr int strips_and_boxes[] = {3, 8};  // divided along one axis, and along two

/// A search for the equilibrium of a plate between two grips, one of which is displaced.
Setup pulled_plate(const RelaxSetup& relax, std::optional<double> critical_stretch = {}) {
  BodySetup plate = fixtures::body_setup({.size = {0.040, 0.032, 0.006}, .spacing = 0.002, .poissons_ratio = 0.3, .critical_stretch = critical_stretch});
  SolidSetup low, high;
  low.name = "low", low.shape = BoxSolid{{0.1, 0.007, 0.1}}, low.position = {0, -0.014, 0};
  high.name = "high", high.shape = BoxSolid{{0.1, 0.007, 0.1}}, high.position = {0, 0.014, 0};
  plate.particle_sets = {low, high};
  DisplacementSetup up;
  up.displacement = 2e-5;
  plate.boundary_conditions = {{"grip", FixedSetup{.particle_set = "low"}}, {"pull", PrescribedSetup{.particle_set = "high", .y = up}}};
  Setup setup;
  setup.time.end = 1;
  setup.time.relax = relax;
  setup.bodies = {plate};
  return setup;
}

}  // namespace

TEST_CASE("ranks: particles, bonds and a free impactor with friction are bitwise those of one rank, for every elastic material and correction that breaks") {
  for (const double nu : {0.25, 0.3})
    for (const SurfaceCorrection correction : {SurfaceCorrection::automatic, SurfaceCorrection::volume})
      for (const fixtures::Model model : {fixtures::Model::ordinary_state, fixtures::Model::linear_solid}) {
        const Setup setup = fixtures::struck_plate({.poissons_ratio = nu, .correction = correction, .critical_stretch = 2e-3, .model = model});
        const Whole one = after(setup, 1);
        CHECK(one.contacts > 10);
        CHECK(std::count(one.bodies[0].bonds.begin(), one.bodies[0].bonds.end(), 0) > 0);
        for (const int ranks : counts) {
          CAPTURE(ranks);
          CAPTURE(nu);
          CAPTURE(static_cast<int>(model));
          check_equal(one, after(setup, ranks));
        }
      }
}

TEST_CASE("ranks: a correspondence body with an initial crack, whose bonds never break, is bitwise that of one rank") {
  Setup setup = fixtures::struck_plate({.model = fixtures::Model::correspondence, .stabilisation = Stabilisation::bond_level});
  setup.bodies[0].cracks = {{"notch", {{-1, 0.005, -1}, {1, 0.005, -1}, {1, 0.005, 1}, {-1, 0.005, 1}}},
                            {"across", {{0.002, -1, -1}, {0.002, 1, -1}, {0.002, 1, 1}, {0.002, -1, 1}}}};
  const Whole one = after(setup, 1);
  CHECK(std::count(one.bodies[0].bonds.begin(), one.bodies[0].bonds.end(), 0) > 0);
  for (const int ranks : strips_and_boxes) {
    CAPTURE(ranks);
    check_equal(one, after(setup, ranks));
  }
}

TEST_CASE("ranks: correspondence materials are bitwise those of one rank") {
  for (const Stabilisation stabilisation : {Stabilisation::bond_level, Stabilisation::wan})
    for (const Plane plane : {Plane::none, Plane::strain}) {
      const Setup setup =
          fixtures::struck_plate({.critical_stretch = 2e-3, .model = fixtures::Model::correspondence, .stabilisation = stabilisation, .plane = plane});
      const Whole one = after(setup, 1);
      CHECK(std::count(one.bodies[0].bonds.begin(), one.bodies[0].bonds.end(), 0) > 0);
      for (const int ranks : strips_and_boxes) {
        CAPTURE(ranks);
        CAPTURE(static_cast<int>(stabilisation));
        check_equal(one, after(setup, ranks));
      }
    }
}

TEST_CASE("ranks: bonds that are stronger under compression, or scattered in strength, break as with one rank") {
  FailureSetup hardening, weibull, limit;
  hardening.compression_hardening = 0.3;
  weibull.weibull_modulus = 8;
  limit.compression = Choice{limit.compression.words, static_cast<int>(CompressionFailure::symmetric)};
  for (const FailureSetup& failure : {hardening, weibull, limit}) {
    const Setup setup = fixtures::struck_plate({.critical_stretch = 2e-3, .failure = failure});
    const Whole one = after(setup, 1);
    CHECK(std::count(one.bodies[0].bonds.begin(), one.bodies[0].bonds.end(), 0) > 0);
    for (const int ranks : strips_and_boxes) {
      CAPTURE(ranks);
      check_equal(one, after(setup, ranks));
    }
  }
}

TEST_CASE("ranks: material that yields under pressure flows as with one rank") {
  for (const double nu : {0.25, 0.3}) {
    Setup setup = fixtures::struck_plate({.poissons_ratio = nu, .critical_stretch = 4e-3});
    PlasticitySetup& plasticity = std::get<OrdinaryStateSetup>(setup.bodies[0].material).plasticity.emplace();
    plasticity.compressive_strength = 400e6;
    const Whole one = after(setup, 1);
    const std::vector<double>& strain = one.bodies[0].values.at("plastic");
    CHECK(std::count_if(strain.begin(), strain.end(), [](double each) { return each > 0; }) > 50);
    for (const int ranks : strips_and_boxes) {
      CAPTURE(ranks);
      CAPTURE(nu);
      check_equal(one, after(setup, ranks));
    }
  }
}

TEST_CASE("ranks: equilibria under prescribed displacements and pressure, with bonds that break, are those of one rank") {
  Setup setup = pulled_plate({.increments = 3, .tolerance = 1e-4}, 1.2e-3);
  setup.bodies[0].boundary_conditions.push_back({"push", PressureSetup{.face = Choice{face_words, 0}, .value = 2e8}});
  const Whole one = after(setup, 1);
  CHECK(std::count(one.bodies[0].bonds.begin(), one.bodies[0].bonds.end(), 0) > 0);
  for (const int ranks : {2, 5}) {
    CAPTURE(ranks);
    check_equal(one, after(setup, ranks));
  }
}

TEST_CASE("ranks: an increment of a search for equilibrium that one rank has interrupted continues bitwise on others") {
  const Setup setup = pulled_plate({.increments = 1, .tolerance = 1e-6});
  const std::uint64_t expected = after(setup, 1).hash;
  Simulation interrupted(setup);  // several ranks complete an increment
  int asked = 0;
  interrupted.step([&](const Relaxed&) { return ++asked < 5; });
  CHECK(interrupted.clock().step == 0);
  const fixtures::WholeState state = fixtures::state_of_all_ranks(interrupted);
  for (const int ranks : {1, 2, 4}) {
    CAPTURE(ranks);
    run_in_process(ranks, [&](Ranks& its) {
      Simulation simulation(setup, {}, its);
      fixtures::take(simulation, state);
      fixtures::run(simulation);
      const std::uint64_t hash = simulation.state_hash();
      if (its.is_root()) CHECK(hash == expected);
    });
  }
}

TEST_CASE("ranks: a floating sheet with a dry top and drag, between fixed and absorbing edges, breaks under a falling ball as with one rank") {
  BodySetup sheet = fixtures::body_setup({.size = {3.6, 2.0, 0.4}, .spacing = 0.1, .critical_stretch = 2e-4, .model = fixtures::Model::bond_based});
  BondBasedSetup ice;
  ice.youngs_modulus = 1.8e9, ice.density = 900, ice.critical_stretch = 2e-4;
  sheet.material = ice;
  SolidSetup left, right;
  left.name = "left", left.shape = BoxSolid{{0.4, 3, 1}}, left.position = {-1.7, 0, 0};
  right.name = "right", right.shape = BoxSolid{{0.6, 3, 1}}, right.position = {1.6, 0, 0};
  sheet.particle_sets = {left, right};
  FloatingSetup water;
  water.drag = 1, water.damping = 2, water.dry_top = 0.1;
  AbsorbingSetup end;
  end.particle_set = "right", end.face = Choice{face_words, 0}, end.reflection = 0.01;
  sheet.boundary_conditions = {{"water", water}, {"edge", FixedSetup{.particle_set = "left"}}, {"end", end}};
  Setup setup;
  setup.time = {.end = 2e-3, .step = 2e-5};
  setup.bodies = {sheet};
  ImpactorSetup ball;
  ball.name = "ball";
  ball.surface = SphereSurface{.diameter = 0.8, .edge_length = 0.1};
  ball.mass = 500;
  ball.position = {-1.4, 0.1, 0.601};  // upon the fixed edge too, whose displacement is imposed again after contact
  ball.velocity = {0, 0, -10};
  ball.free_dofs = {"z"};
  setup.impactors = {ball};
  const Whole one = after(setup, 1);
  CHECK(one.contacts > 0);
  CHECK(std::count(one.bodies[0].bonds.begin(), one.bodies[0].bonds.end(), 0) > 0);
  for (const int ranks : strips_and_boxes) {
    CAPTURE(ranks);
    check_equal(one, after(setup, ranks));
  }
}

TEST_CASE("ranks: contact between fragments and bodies, with friction and restitution, in space and in a plane, is that of one rank") {
  for (const Plane plane : {Plane::none, Plane::strain})
    for (const double restitution : plane == Plane::none ? std::vector{0.7} : std::vector{1.0, 0.7}) {
      Setup setup = fixtures::rubble({.critical_stretch = 2e-3, .plane = plane});
      setup.contact.fragments.restitution = restitution;
      const Whole one = after(setup, 1);
      for (const WholeBody& body : one.bodies) CHECK(std::count(body.bonds.begin(), body.bonds.end(), 0) > 100);
      const auto column = [&](const char* name) { return one.row.at(one.columns.at(name)); };
      CHECK(column("total.friction_dissipation [J]") > 0.1);
      CHECK((restitution == 1 || column("total.dashpot_dissipation [J]") > 0.1));
      for (const int ranks : {2, 3, 7}) {
        CAPTURE(ranks);
        CAPTURE(restitution);
        CAPTURE(static_cast<int>(plane));
        check_equal(one, after(setup, ranks));
      }
    }
}

TEST_CASE("ranks: pairs of particles in range are those of one rank in every step, also where particles become exposed that had no bond to others in range") {
  Setup setup = fixtures::rubble({.critical_stretch = 2e-3});
  setup.time = {.end = 10e-6, .step = 1e-7};
  for (BodySetup& body : setup.bodies) body.horizon_ratio = 1.6, body.family.index = static_cast<int>(FamilyRule::madenci_oterkus);
  const auto hashes_of = [&](int ranks) {
    std::vector<std::uint64_t> hashes;
    run_in_process(ranks, [&](Ranks& its) {
      Simulation simulation(setup, {}, its);
      while (!simulation.clock().is_finished()) {
        simulation.step();
        if (simulation.clock().step % 5 != 0) continue;  // a hash discards the list of pairs, in which exposed particles are marked
        const std::uint64_t hash = simulation.state_hash();
        if (its.is_root()) hashes.push_back(hash);
      }
    });
    return hashes;
  };
  const std::vector<std::uint64_t> expected = hashes_of(1);
  for (const int ranks : {2, 7}) {
    CAPTURE(ranks);
    CHECK(hashes_of(ranks) == expected);
  }
}

TEST_CASE("ranks: fragments that yield are compacted as with one rank") {
  Setup setup = fixtures::rubble({.critical_stretch = 2e-3});
  for (BodySetup& body : setup.bodies) std::get<OrdinaryStateSetup>(body.material).plasticity.emplace().compressive_strength = 400e6;
  setup.contact.fragments.friction = 0;
  const Whole one = after(setup, 1);
  CHECK(one.row.at(one.columns.at("total.compaction_dissipation [J]")) > 0.1);
  for (const int ranks : {4, 5}) {
    CAPTURE(ranks);
    check_equal(one, after(setup, ranks));
  }
}

TEST_CASE("ranks: a body that flies through the territory of other ranks meets the particles of each") {
  // along the plate, which is divided across its length: no rank of a particle in contact is a neighbour on the lattice
  Setup setup = fixtures::rubble({.critical_stretch = 0.02});
  setup.time.end = 70e-6;
  setup.bodies.pop_back();
  setup.bodies[1].position = {-0.041, 0.0003, 0.0002}, setup.bodies[1].velocity = {900, 0, 0};
  const Whole one = after(setup, 1);
  CHECK(std::count(one.bodies[0].bonds.begin(), one.bodies[0].bonds.end(), 0) > 1000);
  for (const int ranks : {4, 8}) {
    CAPTURE(ranks);
    check_equal(one, after(setup, ranks));
  }
}

TEST_CASE("ranks: contact between fragments continues bitwise when its list of pairs is discarded, and from the state of another number of ranks") {
  const Setup setup = fixtures::rubble({.critical_stretch = 2e-3});
  const std::uint64_t expected = after(setup, 1).hash;
  for (const int from : {1, 3}) {
    fixtures::WholeState state;
    std::uint64_t hash_of_state = 0;
    run_in_process(from, [&](Ranks& its) {
      Simulation simulation(setup, {}, its);
      while (simulation.clock().step < simulation.clock().steps / 2) {
        if (simulation.clock().step % 7 == 0) simulation.forget_near_pairs();
        simulation.step();
      }
      const std::uint64_t hash = simulation.state_hash();
      const fixtures::WholeState all = fixtures::state_of_all_ranks(simulation);
      if (its.is_root()) hash_of_state = hash, state = all;
    });
    for (const int ranks : {1, 2, 4, 7}) {
      CAPTURE(from);
      CAPTURE(ranks);
      run_in_process(ranks, [&](Ranks& its) {
        Simulation simulation(setup, {}, its);
        fixtures::take(simulation, state);
        const std::uint64_t taken = simulation.state_hash();
        fixtures::run(simulation);
        const std::uint64_t hash = simulation.state_hash();
        if (!its.is_root()) return;
        CHECK(taken == hash_of_state);
        CHECK(hash == expected);
      });
    }
  }
}

TEST_CASE("ranks: counts of what the published detector rejects are those of one rank") {
  Setup setup = fixtures::struck_plate({.poissons_ratio = 0.3, .critical_stretch = 2e-3});
  setup.contact.impactors.detector.index = static_cast<int>(DetectorKind::published);
  setup.contact.impactors.radius_ratio = 0, setup.contact.impactors.friction = 0;
  const auto rejected = [&](int ranks) {
    std::map<std::string, double> counts;
    run_in_process(ranks, [&](Ranks& its) {
      Simulation simulation(setup, {}, its);
      fixtures::run(simulation);
      simulation.visit_whole_record([&](std::string_view name, auto&& values) {
        if (name.find(".rejected_by_") == std::string_view::npos) return;
        for (const auto number : fccda::numbers_in(values)) counts[std::string(name)] += static_cast<double>(number);
      });
    });
    return counts;
  };
  const std::map<std::string, double> one = rejected(1);
  double all = 0;
  for (const auto& [name, count] : one) all += count;
  CHECK(all > 100);
  for (const int ranks : strips_and_boxes) {
    CAPTURE(ranks);
    CHECK(rejected(ranks) == one);
  }
}
