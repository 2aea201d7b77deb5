// Moving windows: the material around an impactor in place of the whole track (docs/theory/moving_window.md).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/parallel.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/resuming.hpp"
#include "perimpact/simulations.hpp"
#include "perimpact/window_scene.hpp"

using namespace perimpact;

namespace {

using fixtures::Model;
using fixtures::struck_strip;
using fixtures::window_after;

constexpr double spacing = fixtures::window_spacing;
constexpr int added = fixtures::window_added;

/// Particles of the window, at least `margin` cells from its ends, whose velocity, displacement or damage differs in any bit from that of the body of the whole
/// track at the same place, which begins `before` cells earlier; and all such particles.
std::array<std::size_t, 2> differing(const Simulation& window, const Simulation& whole, std::size_t axis, int before, int margin) {
  const Particles &one = window.bodies()[0].particles, &other = whole.bodies()[0].particles;
  const Lattice& lattice = *one.lattice();
  std::array<std::size_t, 2> counts{};
  for (const std::uint32_t slot : one.slot_of()) {
    std::array<int, 3> cell = lattice.cell(slot);
    if (std::min(cell[axis], lattice.cells[axis] - 1 - cell[axis]) < margin) continue;
    cell[axis] += lattice.first[axis] + before;
    const std::size_t same = other.lattice()->slot(cell[0], cell[1], cell[2]);
    counts[0] += one.velocity.at(slot) != other.velocity.at(same) || one.displacement(slot) != other.displacement(same) ||
                 window.bodies()[0].family.damage(slot) != whole.bodies()[0].family.damage(same);
    ++counts[1];
  }
  return counts;
}

}  // namespace

TEST_CASE("moving window: where nothing from its ends can have arrived, a window is bitwise in the state of a body of the whole track") {
  for (const Model model : {Model::bond_based, Model::ordinary_state}) {
    // the sheet is struck, and then the window moves by eight cells; a step carries rounding over three cells, and over six with dilatations
    const int steps = model == Model::bond_based ? 18 : 14, margin = added + steps * (model == Model::bond_based ? 3 : 6), cells = 256;
    Setup with_window = struck_strip(cells, 0, model, steps), of_whole = struck_strip(cells + added, -0.5 * added * spacing, model, steps);
    with_window.bodies[0].moving_window = window_after(0);
    for (Setup* setup : {&with_window, &of_whole}) setup->contact.impactors.crushing_pressure = 1e9, setup->impactors[0].velocity.z = -900;
    Simulation window(with_window), whole(of_whole);
    fixtures::run(window), fixtures::run(whole);
    CHECK(fixtures::count_crushed(window.bodies()[0].particles) > 0);
    CAPTURE(static_cast<int>(model));
    REQUIRE(window.bodies()[0].particles.lattice()->first[0] == -added);
    CHECK(window.bodies()[0].internal.broken_bonds() > 0);
    CHECK(window.bodies()[0].internal.broken_bonds() == whole.bodies()[0].internal.broken_bonds());
    // new material is attached with all its bonds
    CHECK(window.bodies()[0].family.intact_bonds() == window.bodies()[0].family.initial_bonds() - window.bodies()[0].internal.broken_bonds());
    const auto [different, all] = differing(window, whole, 0, added, margin);
    CHECK(different == 0);
    CHECK(all > 1000);
  }
}

TEST_CASE("moving window: contact between fragments acts on after the material has moved, bitwise as in a body of the whole track") {
  // late, and by several moves at once
  constexpr int steps = 36, moves = 5, cells = 512, margin = moves * added + 3 * steps;
  const auto shattered = [&](int length, double centre) {
    Setup setup = struck_strip(length, centre, Model::bond_based, steps, {-5, 0, 0});
    setup.impactors[0].velocity.z = -400;
    setup.impactors[0].mass = 1e-4, setup.impactors[0].free_dofs = {"z"};  // bounces off
    return setup;
  };
  Setup with_window = shattered(cells, 0);
  with_window.bodies[0].moving_window = window_after(0.21);
  Simulation window(with_window), whole(shattered(cells + moves * added, -0.5 * moves * added * spacing));
  fixtures::run(window), fixtures::run(whole);
  REQUIRE(window.bodies()[0].particles.lattice()->first[0] == -moves * added);
  const Body& strip = window.bodies()[0];
  std::size_t uncounted = 0;
  for (const std::uint32_t slot : strip.particles.slot_of()) uncounted += strip.family.damage(slot) > 0 && strip.internal.broken_ends()[slot / 8] == 0;
  REQUIRE(uncounted > 20);  // fragments lie where no bond has broken before
  CHECK(window.fragments()->contacts() > 100);
  CHECK(window.fragments()->contacts() == whole.fragments()->contacts());
  const auto [different, all] = differing(window, whole, 0, moves * added, margin);
  CHECK(different == 0);
  CHECK(all > 1000);
}

TEST_CASE("moving window: ice that has yielded takes its plastic strain along") {
  const int cells = 256, steps = 18;
  const auto yielding = [&](int length, double centre) {
    Setup setup = struck_strip(length, centre, Model::bond_based, steps);
    std::get<BondBasedSetup>(setup.bodies[0].material).plasticity = PlasticitySetup{.compressive_strength = 2e7};
    return setup;
  };
  Setup with_window = yielding(cells, 0);
  with_window.bodies[0].moving_window = window_after(0);
  Simulation window(with_window), whole(yielding(cells + added, -0.5 * added * spacing));
  fixtures::run(window), fixtures::run(whole);
  REQUIRE(window.bodies()[0].particles.lattice()->first[0] == -added);
  const auto [different, all] = differing(window, whole, 0, added, added + 3 * steps);
  CHECK(different == 0);
  CHECK(all > 1000);
  for (const char* total : {"body.broken_bonds [-]", "body.fracture_energy [J]", "body.plastic_dissipation [J]"}) {
    CAPTURE(total);
    CHECK(fixtures::value(window, total) == fixtures::relative(fixtures::value(whole, total), 1e-12));  // rounding: eights add what they have now to what was
  }
}

TEST_CASE("moving window: edges that do not break stay at the ends of ice that yields, and what was an edge breaks like other ice") {
  constexpr int cells = 96, edge = 3;
  constexpr double middle_of_edge = 0.5 * (cells - edge) * spacing;
  Setup setup = struck_strip(cells, 0, Model::bond_based, 60);
  std::get<BondBasedSetup>(setup.bodies[0].material).plasticity = PlasticitySetup{.compressive_strength = 2e7};
  setup.bodies[0].particle_sets = {{.name = "front", .shape = BoxSolid{{edge * spacing, 1, 1}}, .position = {-middle_of_edge, 0, 0}},
                                   {.name = "rear", .shape = BoxSolid{{edge * spacing, 1, 1}}, .position = {middle_of_edge, 0, 0}}};
  setup.bodies[0].failure = FailureSetup{.no_fail = {"front", "rear"}};
  setup.bodies[0].moving_window = window_after(0);
  setup.impactors[1].velocity = {};
  setup.impactors[1].motion.x = TranslationTable{{{0, 2e-6, 2.2e-6}, {-8400, -8400, 0}, {}, {}}};  // 9 spacings: one move
  // arrive after the move, on what was the front edge before, and on what is the rear edge now
  setup.impactors[0].position = {-middle_of_edge, 0, 5.4 * spacing};
  setup.impactors.push_back(fixtures::window_ball("second", {middle_of_edge - added * spacing, 0, 5.4 * spacing}, {0, 0, -150}));
  Simulation simulation(setup);
  while (simulation.moving_windows()[0].travel() == 0) {
    simulation.step();
    REQUIRE(simulation.contacts() == 0);
  }
  fixtures::run(simulation);
  CHECK(simulation.moving_windows()[0].travel() == fixtures::relative(-added * spacing, 1e-12));
  const Body& strip = simulation.bodies()[0];
  std::array<std::size_t, cells> broken{};  // particles that have lost bonds, by their cell along x
  for (const std::uint32_t slot : strip.particles.slot_of())
    broken[static_cast<std::size_t>(strip.particles.lattice()->cell(slot)[0])] += strip.family.damage(slot) > 0;
  for (int cell = 0; cell < edge; ++cell) {
    CAPTURE(cell);
    CHECK(broken[static_cast<std::size_t>(cell)] == 0);
    CHECK(broken[static_cast<std::size_t>(added + cell)] > 0);
    CHECK(broken[static_cast<std::size_t>(cells - 1 - cell)] == 0);
  }
  CHECK(broken[cells - 1 - edge - 2] > 0);
}

TEST_CASE("moving window: new material and ice beside it that has yielded exchange equal and opposite forces") {
  Setup setup = struck_strip(64, 0, Model::bond_based, 20);
  std::get<BondBasedSetup>(setup.bodies[0].material).plasticity = PlasticitySetup{.compressive_strength = 2e7};
  setup.impactors[0].position.z = 1;  // out of contact
  setup.bodies[0].moving_window = window_after(0);
  Simulation simulation(setup);
  const Particles& particles = simulation.bodies()[0].particles;
  simulation.visit_state([&](std::string_view name, auto&& values) {
    using Number = typename std::remove_cvref_t<decltype(fccda::numbers_in(values))>::value_type;
    if constexpr (std::is_same_v<Number, double>) {
      if (name != "body.plastic_strain_xx" && name != "body.equivalent_plastic_strain") return;
      for (const std::uint32_t slot : particles.slot_of())
        if (particles.lattice()->cell(slot)[0] < 2) fccda::numbers_in(values)[slot] = 1e-5;
    } else if constexpr (std::is_same_v<Number, std::uint8_t>) {
      if (name == "body.knows_plastic_strain") std::ranges::fill(fccda::numbers_in(values), 1);
    }
  });
  while (simulation.moving_windows()[0].travel() == 0) simulation.step();
  Vec3d sum{};
  double largest = 0;
  for (const std::uint32_t slot : particles.slot_of()) {
    const Vec3d force = particles.volume(slot) * particles.force_density.at(slot);
    sum += force;
    largest = fixtures::larger(largest, norm(force));
  }
  CHECK(largest > 1);                 // [N], where 191 GPa · 1e-5 acts on the face of a particle, 7 N
  CHECK(norm(sum) < 1e-9 * largest);  // rounding of two thousand forces, each a sum of a hundred
}

TEST_CASE("moving window: broken bonds, fracture energy and plastic dissipation of discarded material remain in the totals") {
  Setup setup = struck_strip(64, 0, Model::bond_based, 14);
  std::get<BondBasedSetup>(setup.bodies[0].material).plasticity = PlasticitySetup{.compressive_strength = 2e7};
  setup.output.history_interval = 2e-7;
  setup.impactors[0].position.x = 28 * spacing;  // over the material that is discarded
  setup.bodies[0].moving_window = window_after(0);
  Simulation simulation(setup);
  const auto total = [&](const char* name) { return fixtures::value(simulation, std::string("body.") + name); };
  const char* names[] = {"broken_bonds [-]", "fracture_energy [J]", "plastic_dissipation [J]"};
  bool has_moved = false;
  while (!simulation.clock().is_finished()) {
    std::vector<double> before;
    for (const char* name : names) before.push_back(total(name));
    simulation.step();
    if (simulation.moving_windows()[0].travel() != 0 && !has_moved) {
      has_moved = true;
      for (const double each : before) CHECK(each > 0);
    }
    for (std::size_t k = 0; k < before.size(); ++k) CHECK(total(names[k]) >= before[k] - 1e-15);  // rounding, where little flows; totals are about 1 J
  }
  REQUIRE(has_moved);
  const Body& body = simulation.bodies()[0];
  CHECK(static_cast<double>(body.family.initial_bonds() - body.family.intact_bonds()) < total("broken_bonds [-]"));  // new material is intact
}

TEST_CASE("moving window: likewise along y, and in the positive direction") {
  const int cells = 256, steps = 18;
  Setup with_window = struck_strip(cells, 0, Model::bond_based, steps, {0, 1, 0});
  with_window.bodies[0].moving_window = window_after(0, WindowAxis::y);
  Simulation window(with_window), whole(struck_strip(cells + added, 0.5 * added * spacing, Model::bond_based, steps, {0, 1, 0}));
  fixtures::run(window), fixtures::run(whole);
  REQUIRE(window.bodies()[0].particles.lattice()->first[1] == added);
  CHECK(window.bodies()[0].internal.broken_bonds() > 0);
  const auto [different, all] = differing(window, whole, 1, 0, added + 3 * steps);
  CHECK(different == 0);
  CHECK(all > 1000);
}

TEST_CASE("moving window: it follows by multiples of eight spacings once the impactor has travelled start_after, never ahead of it, and never back") {
  Setup setup = struck_strip(96, 0, Model::bond_based, 60);
  setup.bodies[0].moving_window = window_after(10 * spacing);
  setup.impactors[1].velocity = {};
  setup.impactors[1].motion.x = TranslationTable{{{0, 1e-5, 1.2e-5}, {-5000, -5000, 5000}, {}, {}}};  // 25 to 30 spacings ahead, then back
  Simulation simulation(setup);
  double furthest = 0;
  while (!simulation.clock().is_finished()) {
    const bool is_row = simulation.clock().step % 5 == 0;
    const double travelled = -simulation.impactors()[1].body().position_of_com().x, before = -simulation.moving_windows()[0].travel();
    furthest = fixtures::larger(furthest, travelled);
    simulation.step();
    const double travel = -simulation.moving_windows()[0].travel();
    CHECK(travel >= before);
    if (!is_row) CHECK(travel == before);
    CHECK(travel <= std::max(0.0, furthest - 10 * spacing) + 1e-12);
    if (is_row) CHECK(travel > furthest - (10 + 8) * spacing - 1e-12);
  }
  CHECK(-simulation.moving_windows()[0].travel() == fixtures::relative(16 * spacing, 1e-12));
}

TEST_CASE("moving window: energy that leaves with discarded material is recorded apart, and the balance closes as without a window") {
  Setup setup = struck_strip(64, 0, Model::bond_based, 0);
  setup.time = {.end = 180e-7, .step = 1e-7};
  setup.output.history_interval = 1e-7;
  setup.impactors[0].position.x = 20 * spacing;  // waves have reached the rear, but not the front, when the window moves
  setup.impactors[1].velocity = {-1094, 0, 0};
  const auto error_of = [](const Simulation& simulation) { return std::abs(fixtures::value(simulation, "total.energy_balance_error [J]")); };
  Simulation without(setup);
  fixtures::run(without);
  setup.bodies[0].moving_window = window_after(0);
  Simulation with(setup);
  // [J] what was put in by the ball, less what is there and what was dissipated
  const auto missing = [](const Simulation& simulation) {
    double sum = -fixtures::value(simulation, "ball.contact_work [J]");
    for (const char* name : {"total.energy", "body.fracture_energy", "total.friction_dissipation", "total.contact_dissipation"})
      sum -= fixtures::value(simulation, std::string(name) + " [J]");
    return sum;
  };
  double left = 0;
  while (!with.clock().is_finished()) {
    const double before = missing(with), travel = with.moving_windows()[0].travel();
    with.step();
    if (with.moving_windows()[0].travel() != travel) left += missing(with) - before;
  }
  CHECK(with.moving_windows()[0].travel() == fixtures::relative(-8 * spacing, 1e-12));
  CHECK(fixtures::value(with, "total.discarded_energy [J]") == fixtures::relative(left, 0.03));  // rows have the kinetic energy of interpolated velocities
  CHECK(left > 20 * error_of(with));
  CHECK(error_of(with) < 1.5 * error_of(without));
}

TEST_CASE(
    "moving window: a restart after every step is bitwise exact, with rubble, moving water, an absorbing end, ice that yields and is crushed by the ball") {
  Setup setup = struck_strip(40, 0, Model::bond_based, 32);
  std::get<BondBasedSetup>(setup.bodies[0].material).plasticity = PlasticitySetup{.compressive_strength = 2e7};
  setup.bodies[0].particle_sets = {{.name = "end", .shape = BoxSolid{{6 * spacing, 1, 1}}, .position = {-20 * spacing, 0, 0}},
                                   {.name = "rear", .shape = BoxSolid{{12 * spacing, 1, 1}}, .position = {20 * spacing, 0, 0}}};
  FloatingSetup water;
  water.level = 0.004, water.entrained_depth = 0.01, water.dry_top = 0.001;
  AbsorbingSetup behind;
  behind.particle_set = "rear", behind.face = Choice{face_words, 0}, behind.reflection = 0.01;
  setup.bodies[0].boundary_conditions = {{"sea", water}, {"ahead", FixedSetup{.particle_set = "end", .directions = {"x", "y"}}}, {"behind", behind}};
  setup.bodies[0].moving_window = window_after(0);
  setup.contact.impactors.crushing_pressure = 4e8;
  setup.impactors[0].velocity.z = -450;
  Simulation simulation(setup);
  std::size_t crushed = 0;
  for (; !simulation.clock().is_finished(); simulation.step()) crushed = fixtures::larger(crushed, fixtures::count_crushed(simulation.bodies()[0].particles));
  CHECK(crushed > 3);  // before the window leaves them behind
  CHECK(std::fabs(fixtures::value(simulation, "body.behind.work [J]")) > 0);
  CHECK(fixtures::value(simulation, "body.broken_bonds [-]") > 0);
  CHECK(fixtures::value(simulation, "body.plastic_dissipation [J]") > 0);
  CHECK(simulation.moving_windows()[0].travel() == fixtures::relative(-24 * spacing, 1e-12));
  fixtures::expect_same_when_resumed_at_every_step(setup);
}

TEST_CASE("moving window: the number of threads changes nothing") {
  Setup setup = struck_strip(40, 0, Model::bond_based, 32);
  setup.bodies[0].moving_window = window_after(0);
  const auto hash = [&](int threads) {
    const fixtures::Threads with_several(threads);
    Simulation simulation(setup);
    fixtures::run(simulation);
    return simulation.state_hash();
  };
  const std::uint64_t one = hash(1), three = hash(3);
  CHECK(one == three);
}

namespace {

/// Takes the bonds of the first eight cells along x in one line, on the inside of the top layer.
void damage_first_cells(Simulation& simulation) {
  const Body& body = simulation.bodies()[0];
  const std::size_t eight = body.particles.lattice()->slot(0, 3, 3) / fccda::byte_lanes, rows = body.family.offsets().size();
  simulation.visit_state([&](std::string_view name, auto&& values) {
    if constexpr (std::is_same_v<typename std::remove_cvref_t<decltype(fccda::numbers_in(values))>::value_type, std::uint8_t>)
      if (name == "body.bonds") std::ranges::fill(fccda::numbers_in(values).subspan(eight * rows, rows), std::uint8_t{0});
  });
  REQUIRE(body.family.damage(eight * fccda::byte_lanes) == 1);
}

}  // namespace

TEST_CASE("moving window: new material matches a front that is displaced, rotated and moving, also beside damage, and breaks no bond") {
  // by a spacing, and rotated by 1e-3 about y and z; bonds endure a strain of 4e-4
  const auto displacement = [](const Vec3d& X) { return spacing * Vec3d{0.2, -0.3, 1} + Vec3d{-1e-3 * X.z + 1e-3 * X.y, -1e-3 * X.x, 1e-3 * X.x}; };
  const auto velocity = [](const Vec3d& X) { return Vec3d{-2 * X.z, 0, 2 * X.x + 0.01}; };  // [m/s]
  for (const bool along_x : {true, false})
    for (const double sign : {-1.0, 1.0}) {
      CAPTURE(along_x);
      CAPTURE(sign);
      Setup setup = struck_strip(64, 0, Model::bond_based, 20, along_x ? Vec3d{sign, 0, 0} : Vec3d{0, sign, 0});
      setup.impactors[0].position.z = 1;  // out of contact
      setup.bodies[0].moving_window = window_after(0, along_x ? WindowAxis::x : WindowAxis::y);
      Simulation simulation(setup);
      const Body& body = simulation.bodies()[0];
      const Particles& particles = body.particles;
      simulation.visit_state([&](std::string_view name, auto&& values) {
        if constexpr (std::is_same_v<typename std::remove_cvref_t<decltype(fccda::numbers_in(values))>::value_type, double>)
          for (std::size_t c = 0; c < 3; ++c)
            for (const std::uint32_t slot : particles.slot_of()) {
              const Vec3d X = particles.reference(slot);
              if (name == std::string("body.position_") + "xyz"[c]) fccda::numbers_in(values)[slot] = X[c] + displacement(X)[c];
              if (name == std::string("body.velocity_") + "xyz"[c]) fccda::numbers_in(values)[slot] = velocity(X)[c];
            }
      });
      if (along_x && sign < 0) damage_first_cells(simulation);
      while (simulation.moving_windows()[0].travel() == 0) simulation.step();
      const double time = simulation.clock().time();
      double off = 0, off_velocity = 0;
      for (const std::uint32_t slot : particles.slot_of()) {
        const Vec3d X = particles.reference(slot);
        off = fixtures::larger(off, norm(particles.displacement(slot) - displacement(X) - time * velocity(X)));
        off_velocity = fixtures::larger(off_velocity, norm(particles.velocity.at(slot) - velocity(X)));
      }
      // the rotation stretches by 1e-6: waves with some times 1e-6 of 5 km/s, and their way in 2 µs
      CHECK(off < 1e-3 * spacing);
      CHECK(off_velocity < 0.1);
      fixtures::run(simulation);
      CHECK(body.internal.broken_bonds() == 0);
      const std::vector<std::string> warnings = simulation.closing_warnings();
      const auto warned = std::ranges::count_if(warnings, [](const std::string& one) { return one.starts_with("The moving window"); });
      CHECK(warned == (along_x && sign < 0 ? 1 : 0));
    }
}
