// Moving windows: the material around an impactor in place of the whole track (docs/theory/moving_window.md).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
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

using namespace perimpact;

namespace {

using fixtures::Model;

constexpr double spacing = 1.0 / 512;  // [m]; positions on the lattice are exact, so that they do not depend on its first cell
constexpr int added = 8;               // cells of a move

ImpactorSetup ball(const std::string& name, double diameter, const Vec3d& position, const Vec3d& velocity) {
  ImpactorSetup setup;
  setup.name = name;
  setup.surface = SphereSurface{.diameter = diameter, .edge_length = diameter / 8};
  setup.mass = 0.05;
  setup.position = position;
  setup.velocity = velocity;
  return setup;
}

/// A strip of cells along x, struck in its middle, and a remote impactor that travels somewhat more than eight spacings in ten steps.
Setup struck(int cells, double centre, Model model, int steps, const Vec3d& direction = {-1, 0, 0}) {
  Setup setup;
  setup.time = {.end = steps * 2e-7, .step = 2e-7};
  setup.output.history_interval = 1e-6;
  const double across = 8 * spacing, length = cells * spacing;
  const bool along_x = direction.x != 0;
  BodySetup strip = fixtures::body_setup({.size = along_x ? Vec3d{length, across, 4 * spacing} : Vec3d{across, length, 4 * spacing},
                                          .spacing = spacing,
                                          .critical_stretch = 4e-4,
                                          .model = model});
  strip.position = along_x ? Vec3d{centre, 0, 0} : Vec3d{0, centre, 0};
  setup.bodies = {strip};
  const double top = 2 * spacing;
  setup.impactors = {ball("ball", 6 * spacing, {0.3 * spacing, 0.2 * spacing, top + 3 * spacing}, {0, 0, -150}),
                     ball("guide", 6 * spacing, {0, 0, 1}, 8400 * direction)};
  setup.contact.fragments.law.index = 1;
  setup.contact.fragments.friction = 0.2;
  return setup;
}

MovingWindowSetup window_after(double travel, WindowAxis axis = WindowAxis::x) {
  MovingWindowSetup window{.follow = "guide", .start_after = travel};
  window.axis.index = static_cast<int>(axis);
  return window;
}

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
    Setup with_window = struck(cells, 0, model, steps), of_whole = struck(cells + added, -0.5 * added * spacing, model, steps);
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
    Setup setup = struck(length, centre, Model::bond_based, steps, {-5, 0, 0});
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
    Setup setup = struck(length, centre, Model::bond_based, steps);
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
  Setup setup = struck(cells, 0, Model::bond_based, 60);
  std::get<BondBasedSetup>(setup.bodies[0].material).plasticity = PlasticitySetup{.compressive_strength = 2e7};
  setup.bodies[0].particle_sets = {{.name = "front", .shape = BoxSolid{{edge * spacing, 1, 1}}, .position = {-middle_of_edge, 0, 0}},
                                   {.name = "rear", .shape = BoxSolid{{edge * spacing, 1, 1}}, .position = {middle_of_edge, 0, 0}}};
  setup.bodies[0].failure = FailureSetup{.no_fail = {"front", "rear"}};
  setup.bodies[0].moving_window = window_after(0);
  setup.impactors[1].velocity = {};
  setup.impactors[1].motion.x = TranslationTable{{{0, 2e-6, 2.2e-6}, {-8400, -8400, 0}, {}, {}}};  // 9 spacings: one move
  // arrive after the move, on what was the front edge before, and on what is the rear edge now
  setup.impactors[0].position = {-middle_of_edge, 0, 5.4 * spacing};
  setup.impactors.push_back(ball("second", 6 * spacing, {middle_of_edge - added * spacing, 0, 5.4 * spacing}, {0, 0, -150}));
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
  Setup setup = struck(64, 0, Model::bond_based, 20);
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
  Setup setup = struck(64, 0, Model::bond_based, 14);
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
  Setup with_window = struck(cells, 0, Model::bond_based, steps, {0, 1, 0});
  with_window.bodies[0].moving_window = window_after(0, WindowAxis::y);
  Simulation window(with_window), whole(struck(cells + added, 0.5 * added * spacing, Model::bond_based, steps, {0, 1, 0}));
  fixtures::run(window), fixtures::run(whole);
  REQUIRE(window.bodies()[0].particles.lattice()->first[1] == added);
  CHECK(window.bodies()[0].internal.broken_bonds() > 0);
  const auto [different, all] = differing(window, whole, 1, 0, added + 3 * steps);
  CHECK(different == 0);
  CHECK(all > 1000);
}

TEST_CASE("moving window: it follows by multiples of eight spacings once the impactor has travelled start_after, never ahead of it, and never back") {
  Setup setup = struck(96, 0, Model::bond_based, 60);
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
  Setup setup = struck(64, 0, Model::bond_based, 0);
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
  Setup setup = struck(40, 0, Model::bond_based, 32);
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
  Setup setup = struck(40, 0, Model::bond_based, 32);
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
      Setup setup = struck(64, 0, Model::bond_based, 20, along_x ? Vec3d{sign, 0, 0} : Vec3d{0, sign, 0});
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

TEST_CASE("moving window: a window whose front is damaged when it moves is reported at the end") {
  Setup setup = struck(40, 0, Model::bond_based, 60);
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
    Setup setup = struck(cells, 0, Model::bond_based, steps);
    setup.bodies[0].moving_window = window_after(0);
    setup.impactors.push_back(ball("pile", 4 * spacing, {-(cells / 2 + beyond) * spacing, 0, 0}, {}));
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
    Setup setup = struck(cells, 0, Model::bond_based, steps);
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
    Setup setup = struck(cells, 0, Model::bond_based, steps);
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

TEST_CASE("moving window: a window whose impactor does not move along its axis is warned of") {
  const auto warned = [](const Setup& setup) {
    return std::ranges::any_of(Simulation(setup).warnings(), [](const std::string& one) {
      return one.starts_with("The moving window of body body follows impactor guide, which does not move along y: ");
    });
  };
  Setup setup = struck(40, 0, Model::bond_based, 10, {0, -1, 0});
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
    Setup setup = struck(40, 0, Model::bond_based, 10);
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
