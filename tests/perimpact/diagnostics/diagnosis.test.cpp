#include "perimpact/diagnostics/diagnosis.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "fixtures/temporary_folder.hpp"
#include "perimpact/body/body.hpp"

using namespace perimpact;

namespace {

/// The cylinder of the plate benchmark, and its target.
ImpactorSetup cylinder() {
  ImpactorSetup setup;
  setup.name = "cylinder";
  setup.surface = CylinderSurface{.diameter = 0.05, .height = 0.025, .edge_length = 0.001};
  setup.mass = 1.57;
  setup.position = {0, 0.075, 0};
  setup.velocity = {0, -32, 0};
  return setup;
}

constexpr double dt = 1e-7;

Target plate() { return {.name = "plate", .spacing = 0.001, .contact_radius = 0.0005, .size = {0.2, 0.1, 0.009}}; }

Impactor made(const ImpactorSetup& setup) { return Impactor(setup, {}, {}); }

bool holds(const Diagnosis& diagnosis, const std::string& words) { return diagnosis && diagnosis->find(words) != std::string::npos; }

}  // namespace

TEST_CASE("diagnosis: the plate benchmark yields no warnings") {
  const Impactor impactor = made(cylinder());
  CHECK_FALSE(inside_out(impactor).has_value());
  CHECK(diagnose(impactor, plate(), dt).empty());
}

TEST_CASE("diagnosis: panels below a quarter of the spacing, but not just above") {
  const Impactor impactor = made(cylinder());
  Target target = plate();
  target.spacing = 0.0039;  // the median panel of a cylinder of 1 mm panels is a little less than 1 mm
  CHECK_FALSE(panels_too_fine(impactor, target).has_value());
  target.spacing = 0.0042;
  CHECK(holds(panels_too_fine(impactor, target), "less than a quarter of the spacing of body plate (0.0042 m)"));
}

TEST_CASE("diagnosis: facets more than half a spacing off the cylinder, but no flat panels of any size") {
  ImpactorSetup setup = cylinder();
  setup.surface = CylinderSurface{.diameter = 0.05, .height = 0.025, .edge_length = 0.009};  // 0.009²/(8 · 0.025) = 0.41 mm
  CHECK_FALSE(panels_too_coarse(made(setup), plate()).has_value());
  setup.surface = CylinderSurface{.diameter = 0.05, .height = 0.025, .edge_length = 0.013};  // 0.85 mm
  CHECK(holds(panels_too_coarse(made(setup), plate()), "more than half of the spacing of body plate (0.001 m)"));
  setup.surface = BoxSurface{.size = {1, 1, 1}, .edge_length = 1};
  CHECK(diagnose(made(setup), plate(), dt).empty());
}

TEST_CASE("diagnosis: a surface in millimetres exceeds a hundred bodies in size") {
  ImpactorSetup setup = cylinder();
  setup.surface = BoxSurface{.size = {50, 25, 25}, .edge_length = 50};
  CHECK(holds(panels_of_another_unit(made(setup), plate()), "scale: 0.001"));
}

TEST_CASE("diagnosis: a needle and a grain pass between particles, a thin blade does not") {
  ImpactorSetup setup = cylinder();
  setup.surface = BoxSurface{.size = {0.1, 0.002, 0.002}, .edge_length = 0.002};
  CHECK(holds(falls_between(made(setup), plate()), "passes between them"));
  setup.surface = SphereSurface{.diameter = 0.001, .edge_length = 0.0003};
  CHECK(falls_between(made(setup), plate()).has_value());
  setup.surface = BoxSurface{.size = {0.1, 0.05, 0.001}, .edge_length = 0.005};
  CHECK_FALSE(falls_between(made(setup), plate()).has_value());
}

TEST_CASE("diagnosis: a step with motion through a thin plate names panel, position and a suitable step") {
  ImpactorSetup setup = cylinder();
  setup.surface = BoxSurface{.size = {0.1, 0.0004, 0.1}, .edge_length = 0.02};
  const Impactor thin = made(setup);
  CHECK_FALSE(step_through(thin, plate(), 1.2e-5).has_value());   // 32 m/s · 12 µs = 0.38 mm
  const Diagnosis through = step_through(thin, plate(), 1.5e-5);  // 0.48 mm
  CHECK(holds(through, "is 0.00048 m at panel "));
  CHECK(holds(through, "where the thickness is only 0.0004 m"));
  CHECK(holds(through, "at most 1.2e-05 s"));  // 0.4 mm at 32 m/s, to two digits
}

TEST_CASE("diagnosis: the motion per step follows from the maximum of a table, and the suggested step keeps it below a spacing") {
  ImpactorSetup setup = cylinder();
  setup.velocity = {};
  TranslationTable& table = setup.motion.y.emplace();
  table.times = {0, 1, 2, 3}, table.velocities = {0, 10, -32, 0};
  CHECK_FALSE(step_through(made(setup), plate(), 3.1e-5).has_value());  // 32 m/s: 0.99 mm
  CHECK(holds(step_through(made(setup), plate(), 3.2e-5), "at most 3.1e-05 s"));
  table.velocities = {}, table.displacements = {0, 10, -22, -22};  // the same speed
  CHECK_FALSE(step_through(made(setup), plate(), 3.1e-5).has_value());
  CHECK(step_through(made(setup), plate(), 3.2e-5).has_value());
  setup.surface = BoxSurface{.size = {0.1, 0.003, 0.1}, .edge_length = 0.02};  // 3 mm thick, thrice the spacing
  CHECK(holds(step_through(made(setup), plate(), 1e-4), "at most 3.1e-05 s"));
}

TEST_CASE("diagnosis: particles behind an open surface are counted, but not those in front of it or beyond its boundary edge") {
  const fixtures::TemporaryFolder folder;
  const std::filesystem::path file = folder / "open_square.obj";
  std::ofstream(file) << "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 2 3 4\n";  // normal -y
  ImpactorSetup setup = cylinder();
  FileSurface square{.file = file.string()};
  square.orientation.index = 1;  // normals
  setup.surface = square;
  setup.position = {}, setup.velocity = {};
  // 4 x 4 x 1 particles, half a metre apart, about the square: y from -0.75 to 0.75
  BodySetup body;
  body.name = "block", body.shape = BoxSolid{.size = {2, 2, 0.5}}, body.spacing = 0.5;
  body.material = OrdinaryStateSetup{{.youngs_modulus = 1, .density = 1}};
  const Particles particles = make_particles(body);
  const Impactor wall = made(setup);
  CHECK(particles_behind(wall, particles) == 8);
  CHECK(holds(starts_behind(wall, plate(), particles), "8 of the 16 particles of body plate start behind the open surface of impactor cylinder"));
  setup.position = {1.5, 0, 0};  // its edge is at x = 0.5: half of the particles lie beyond it
  CHECK(particles_behind(made(setup), particles) == 2);
  setup.surface = BoxSurface{.size = {3, 3, 3}, .edge_length = 1};
  CHECK(particles_behind(made(setup), particles) == 0);  // closed: handled by initial_overlap
}

TEST_CASE("diagnosis: the motion per step includes particle velocity and rotation of the surface, and equal velocities give none") {
  ImpactorSetup setup = cylinder();
  Target target = plate();
  target.velocity = {0, -32, 0};
  CHECK_FALSE(step_through(made(setup), target, 1).has_value());
  target.velocity = {0, 32, 0};
  CHECK_FALSE(step_through(made(setup), target, 1.5e-5).has_value());  // 0.96 mm
  CHECK(holds(step_through(made(setup), target, 1.6e-5), "more than a spacing (0.001 m)"));
  setup.velocity = {}, target.velocity = {};
  setup.angular_velocity = {0, 0, 1000};  // 25 m/s at the rim
  CHECK_FALSE(step_through(made(setup), target, 3.9e-5).has_value());
  CHECK(step_through(made(setup), target, 4.1e-5).has_value());
}
