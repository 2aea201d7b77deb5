#include "perimpact/impactor/in_plane.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "fixtures/temporary_folder.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;
using fixtures::complaint;

namespace {

constexpr double spacing = 0.002, height = 0.03;  // [m]; `height`: of the plane z

/// A plane plate off the origin's height, and a cylinder through its plane in off-centre contact with an edge.
Setup impacted_plate() {
  Setup setup;
  setup.time = {.end = 30e-6, .step = 1e-7};
  BodySetup plate = fixtures::body_setup({.size = {0.04, 0.02, 0.003}, .spacing = spacing, .plane = Plane::stress});
  plate.name = "plate";
  plate.position = {0, 0, height};
  setup.bodies = {plate};
  ImpactorSetup cylinder;
  cylinder.name = "cylinder";
  cylinder.surface = CylinderSurface{.diameter = 0.02, .height = 0.01, .edge_length = 0.002};
  cylinder.mass = 0.05;
  cylinder.position = {0.003, 0.0206, height};
  cylinder.velocity = {2, -30, 0};
  cylinder.free_dofs = {"x", "y", "rz"};
  setup.impactors = {cylinder};
  setup.contact.impactors.friction = 0.3;
  setup.output.history_interval = 5e-6;
  return setup;
}

bool holds(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

}  // namespace

TEST_CASE("in plane: a plane body in contact stays bitwise in its plane, and momentum in the plane is conserved") {
  Simulation simulation(impacted_plate());
  const Particles& particles = simulation.bodies()[0].particles;
  const Vec3d start = 0.05 * Vec3d{2, -30, 0};
  while (!simulation.clock().is_finished()) simulation.step();
  Vec3d momentum{};
  for (const std::uint32_t slot : particles.slot_of()) {
    CHECK(particles.position.at(slot).z == height);
    CHECK(particles.velocity.at(slot).z == 0);
    momentum += particles.mass(slot) * particles.velocity.at(slot);
  }
  const Impactor& cylinder = simulation.impactors()[0];
  REQUIRE(norm(cylinder.account().impulse) + norm(momentum) > 0.1);  // [kg m/s]; contact occurred
  CHECK(cylinder.body().velocity().z == 0);
  CHECK(cylinder.body().pose().position().z == height);
  const Vec3d after = 0.05 * cylinder.body().velocity() + momentum;
  CHECK(norm(after - start) <= 1e-12 * norm(start));  // rounding of 300 steps
}

TEST_CASE("in plane: an impactor that can leave the plane is refused") {
  const char* sentence = "body that it may contact is plane: restrict it to motion along x and y";
  CHECK(complaint(impacted_plate()).empty());
  Setup setup = impacted_plate();
  setup.impactors[0].velocity.z = 0.1;
  CHECK(holds(complaint(setup), "impactors.cylinder: cylinder moves or is free in z, but a"));
  CHECK(holds(complaint(setup), sentence));
  setup = impacted_plate();
  setup.impactors[0].free_dofs.push_back("ry");
  CHECK(holds(complaint(setup), "is free in ry"));
  setup = impacted_plate();
  setup.impactors[0].free_dofs = {"x", "y"};
  setup.impactors[0].angular_velocity = {1, 0, 0};
  CHECK(holds(complaint(setup), "is free in rx"));
}

TEST_CASE("in plane: an open surface must extend through the plane") {
  const ::fixtures::TemporaryFolder folder;
  Setup setup = impacted_plate();
  const auto wall = [&](double low) {
    ::fixtures::put(folder / "wall.obj",
                    "v -0.01 0 " + std::to_string(low) + "\nv 0.01 0 " + std::to_string(low) + "\nv 0.01 0 0.04\nv -0.01 0 0.04\nf 1 2 3 4\n");
    setup.impactors[0].surface =
        FileSurface{.file = (folder / "wall.obj").string(), .orientation = Choice{open_side_words, static_cast<int>(fccda::Orientation::normals)}};
    setup.impactors[0].position = {0, 0.0121, 0};
    setup.impactors[0].inertia = Vec3d{1e-6, 1e-6, 1e-6};
    return complaint(setup);
  };
  CHECK(wall(0.026).empty());
  CHECK(holds(wall(0.0285), "but the surface ends near there: at ("));
  CHECK(holds(wall(0.0303), "but the surface ends near there: at ("));
}

TEST_CASE("in plane: a surface must be prismatic where contact spheres can meet it, and only there") {
  const char* sentence = "the surface does not run along z where it meets it: a panel at";
  Setup setup = impacted_plate();
  setup.impactors[0].position.z = height + 0.0019;  // the lower end 3.1 mm under the plane, a spacing and a contact radius being 3 mm
  CHECK(complaint(setup).empty());
  setup.impactors[0].position.z = height + 0.0021;
  CHECK(holds(complaint(setup), sentence));
  CHECK(holds(complaint(setup), "is inclined by 90 degrees"));
  setup.impactors[0].surface = SphereSurface{.diameter = 0.02, .edge_length = 0.002};
  setup.impactors[0].position.z = height;
  CHECK(holds(complaint(setup), sentence));
  setup.impactors[0].surface = CylinderSurface{.diameter = 0.02, .height = 0.01, .axis = Choice{axis_words, 0}, .edge_length = 0.002};
  CHECK(holds(complaint(setup), sentence));
  setup.impactors[0].surface = BoxSurface{.size = {0.01, 0.01, 0.01}, .edge_length = 0.005};
  CHECK(complaint(setup).empty());
}
