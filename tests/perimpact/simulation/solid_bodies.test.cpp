// Bodies of solids with holes and cracks, plane ones, and clouds: from the Setup to the first steps.
#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "fixtures/gmsh_files.hpp"
#include "fixtures/keyword_files.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::complaint;

namespace {

/// A ball of 16 mm with a bore along z, cut along y = 0 from its surface to the bore's axis.
BodySetup ball() {
  BodySetup setup = fixtures::body_setup({.spacing = 0.001});
  setup.shape = SphereSolid{0.016};
  setup.position = {0.1, 0, 0};
  setup.holes = {{"bore", CylinderSolid{0.004, 0.1, {axis_words, 2}}, {}, {}}};
  setup.cracks = {{"notch", {{0, 0, -0.02}, {0.02, 0, -0.02}, {0.02, 0, 0.02}, {0, 0, 0.02}}}};
  return setup;
}

bool warns_of(const Simulation& simulation, std::string_view words) {
  const auto& warnings = simulation.warnings();
  return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

Setup run_of(BodySetup body) { return {.time = {.end = 1e-6, .step = {}}, .bodies = {std::move(body)}}; }

}  // namespace

TEST_CASE("solid bodies: a ball has the expected particles, none in its bore, and no bond across its crack") {
  const BodySetup setup = ball();
  const Body body = make_body(setup);
  const double radius = 0.008, bore = 0.002;
  std::size_t expected = 0;  // cells of a lattice of 16 along each axis, about the centre
  for (int c = 0; c < 16 * 16 * 16; ++c) {
    const Vec3d X = 0.001 * Vec3d{c % 16 - 7.5, c / 16 % 16 - 7.5, c / 256 - 7.5};
    expected += norm(X) <= radius && std::hypot(X.x, X.y) > bore ? 1 : 0;
  }
  CHECK(body.particles.size() == expected);

  const Body whole = make_body([&] {
    BodySetup uncut = setup;
    uncut.cracks.clear();
    return uncut;
  }());
  std::size_t over = 0;  // by hand: the half plane x > 0 of y = 0
  for (const std::uint32_t i : whole.particles.slot_of()) {
    const Vec3d Xi = whole.particles.reference(i) - setup.position;
    whole.family.for_each_bond(i, [&](const FamilyBond& bond) {
      const Vec3d Xj = whole.particles.reference(bond.j) - setup.position;
      if (Xi.y < 0 && Xj.y > 0 && Xi.x + Xi.y / (Xi.y - Xj.y) * (Xj.x - Xi.x) > -1e-9) ++over;  // bonds through the end of the crack are cut
    });
  }
  REQUIRE(body.cracks.size() == 1);
  CHECK(body.cracks[0].bonds == over);
  CHECK(body.cracks[0].in_plane == 0);
  CHECK(whole.family.intact_bonds() - body.family.intact_bonds() == over);
  CHECK(body.family.initial_bonds() == whole.family.initial_bonds());  // cut bonds count as damage
}

TEST_CASE("solid bodies: the mass of the solid is known, and a lattice too coarse for it is reported") {
  BodySetup setup = ball();
  setup.holes.clear(), setup.cracks.clear();
  const Simulation fine(run_of(setup));
  REQUIRE(fine.filled_mass(0).has_value());
  CHECK(fine.filled_mass(0)->solid == fixtures::relative(fixtures::density * std::numbers::pi / 6 * 0.016 * 0.016 * 0.016, 1e-12));
  CHECK(fine.filled_mass(0)->particles == fixtures::relative(fine.bodies()[0].particles.total_mass(), 1e-12));
  CHECK(!warns_of(fine, "relative to its solid"));
  setup.spacing = 0.0065;  // two by two by two cells, 2197 mm³ of 3217 mm³
  setup.shape = CylinderSolid{0.016, 0.016, {axis_words, 2}};
  CHECK(warns_of(Simulation(run_of(setup)), "-31.7 % relative to its solid of 0.02574 kg: the lattice is too coarse. Use a smaller spacing."));
  CHECK(!Simulation(run_of(ball())).filled_mass(0).has_value());
}

TEST_CASE("solid bodies: a body without particles is refused, particles without bonds are reported") {
  BodySetup setup = ball();
  std::string key;
  setup.holes = {{"all", BoxSolid{{1, 1, 1}}, {}, {}}};
  CHECK(complaint(run_of(setup), key) ==
        "no particle of a lattice of 0.001 m is inside body body; take a smaller spacing, or check the units of its shape and holes.");
  CHECK(key == "bodies.body.spacing");
  setup = ball();
  setup.cracks.clear();
  setup.add = {{"crumb", BoxSolid{{0.001, 0.001, 0.001}}, {0.0205, 0.0005, 0.0005}, {}}};
  CHECK(warns_of(Simulation(run_of(setup)), "1 particles of body body have no bonds, because the solid is too thin there"));
}

TEST_CASE("solid bodies: invalid cracks and cracks outside the body are refused at their polygon") {
  std::string key;
  BodySetup setup = ball();
  setup.cracks[0].polygon.resize(2);
  CHECK(complaint(run_of(setup), key).starts_with("the crack has 2 corners, but a polygon needs at least three"));
  CHECK(key == "bodies.body.cracks.notch.polygon");
  setup = ball();
  for (Vec3d& corner : setup.cracks[0].polygon) corner.y = 1;
  CHECK(complaint(run_of(setup), key) ==
        "the crack notch cuts no bond of body body: it lies outside the body, or coincides with another crack; its corners are relative to the body's "
        "position, in metres.");
}

TEST_CASE("solid bodies: a crack in a layer of particles separates it from the one below, with a warning") {
  BodySetup setup = fixtures::body_setup({.size = {0.005, 0.005, 0.005}, .spacing = 0.001});  // the middle layer is at z = 0
  setup.cracks = {{"middle", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}};              // normal up
  const Simulation simulation(run_of(setup));
  const Body& body = simulation.bodies()[0];
  for (const std::uint32_t i : body.particles.slot_of())
    body.family.for_each_bond(i, [&](const FamilyBond& bond) {
      const auto is_above = [&](std::size_t slot) { return body.particles.reference(slot).z > -1e-6; };
      CHECK(is_above(i) == is_above(bond.j));
    });
  CHECK(warns_of(simulation, "25 particles of body body lie in the plane of crack middle and are assigned to the side of its normal."));
}

TEST_CASE("solid bodies: a plane disc with a hole and a crack is one layer as thick as its cylinder") {
  BodySetup setup = ball();
  setup.plane.index = 1;
  setup.shape = CylinderSolid{0.02, 0.003, {axis_words, 2}};
  setup.cracks[0].polygon = {{0, 0, 0}, {0.02, 0, 0}};
  const Body body = make_body(setup);
  CHECK(body.particles.thickness() == fixtures::relative(0.003, 1e-12));
  CHECK(body.particles.lattice()->cells[2] == 1);
  for (const std::uint32_t slot : body.particles.slot_of()) CHECK(body.particles.reference(slot).z == 0);
  // π (10² - 2²) cells, to a tenth of those on the circumferences of 2 π 12
  CHECK(static_cast<double>(body.particles.size()) == fixtures::relative(std::numbers::pi * 96, 0.025));
  CHECK(body.cracks[0].bonds > 0);
}

TEST_CASE("solid bodies: the cells of a Gmsh mesh form a body in free flight, with particle sets by position") {
  const ::fixtures::TemporaryFolder folder;
  const fccda::Elements block = ::fixtures::block_of(fccda::ElementKind::tetrahedron, 4);
  ::fixtures::GmshMesh mesh;
  mesh.vertices = block.vertices;
  for (std::size_t e = 0; e < block.size(); ++e) mesh.elements.push_back({4, {block.nodes_of_element(e).begin(), block.nodes_of_element(e).end()}});
  ::fixtures::put(folder / "block.msh", ::fixtures::gmsh_file(mesh));
  BodySetup setup = fixtures::body_setup({});
  CellsShape cells;
  cells.file = (folder / "block.msh").string(), cells.scale = 0.001;
  setup.shape = cells, setup.spacing.reset(), setup.velocity = {3, 0, 0};
  setup.cracks = {{"notch", {{0.002, -1, -1}, {0.002, 1, -1}, {0.002, 1, 1}, {0.002, -1, 1}}}};
  Simulation simulation(run_of(setup));
  const Body& body = simulation.bodies()[0];
  CHECK(body.particles.size() == 6 * 64);
  CHECK(body.particles.total_mass() == fixtures::relative(fixtures::density * 64e-9, 1e-12));
  CHECK(body.particles.numbers().size() == 6 * 64);
  CHECK(body.cracks[0].bonds > 0);
  for (int step = 0; step < 5; ++step) simulation.step();
  // no force acts on a body that moves as a whole, but for the rounding of its bonds' stretches, 1e-16 E/(ρ size) per second
  const Vec3d mean = body.motion().momentum / body.particles.total_mass();
  CHECK(norm(mean - Vec3d{3, 0, 0}) < 1e-9);
}
