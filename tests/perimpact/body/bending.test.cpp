// Bending stiffness of few layers: against a beam bent by relaxation, independent of columns and bulges.
#include "perimpact/body/bending.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "fixtures/tolerance.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/materials/ordinary_state/stencil_sums.hpp"
#include "perimpact/simulations.hpp"

using namespace perimpact;

namespace {

constexpr double E = 2e9, nu = 0.25, spacing = 0.5;

double relative(int layers, const Plane plane = Plane::none, double poissons_ratio = nu) {
  const bool is_plane = plane != Plane::none;
  const std::optional<double> thickness = is_plane ? std::optional(1.0) : std::nullopt;
  const Stencil stencil(FamilyRule::hu_ha_bobaru, spacing, 3.015, thickness);
  const IsotropicElastic elastic = IsotropicElastic::in(static_cast<Plane>(plane), E, poissons_ratio);
  const FamilySums sums = sums_of(stencil, madenci_oterkus_influences, elastic.poissons_ratio);
  const OrdinaryState law(elastic, madenci_oterkus_influences, stencil.horizon(), thickness.value_or(1), sums);
  return relative_bending_stiffness({spacing, thickness, is_plane ? 1u : 2u, layers}, law, CorrectionKind::energy, stencil);
}

/// A cantilever along x, clamped at its left end over three columns, loaded at its right face.
Setup cantilever(int layers, int width, int length, const char* calibration, double force) {
  BodySetup body{.name = "beam", .spacing = spacing};
  const Vec3d size{length * spacing, width * spacing, layers * spacing};
  body.shape = BoxSolid{size};
  OrdinaryStateSetup material;
  material.youngs_modulus = E, material.poissons_ratio = nu, material.density = 1000;
  body.material = material;
  for (int axis = 0; axis <= 3; ++axis)
    if (thin_axis_words[axis] == calibration) body.bending_calibration.index = axis;
  const auto end = [&](const std::string& name, int columns, double sign) {
    SolidSetup region{.name = name};
    region.position = {sign * 0.5 * (length - columns) * spacing, 0, 0};
    region.shape = BoxSolid{{columns * spacing, size.y, size.z}};
    body.particle_sets.push_back(region);
  };
  end("held", 3, -1);
  end("pushed", 1, 1);
  FixedSetup fixed;
  fixed.particle_set = "held";
  BodyForceSetup load;
  load.particle_set = "pushed";
  load.force_density = {0, 0, -force / (size.y * size.z * spacing)};
  body.boundary_conditions = {{"wall", fixed}, {"push", load}};
  Setup setup;
  setup.time.end = 1;
  setup.time.relax = RelaxSetup{};
  setup.bodies.push_back(body);
  setup.output.probes.push_back({"tip", "beam", {0.5 * (length - 1) * spacing, 0, 0}});
  return setup;
}

}  // namespace

TEST_CASE("bending: many layers have the stiffness of a plate") {
  // bonds between interior and surface, 1 to 2 % off after the correction, count less the thicker the body is
  CHECK(relative(24) == fixtures::relative(1, 0.015));
  CHECK(relative(24, Plane::stress) == fixtures::relative(1, 0.015));
  CHECK(relative(24, Plane::strain, 0.3) == fixtures::relative(1, 0.015));
  CHECK(relative(24, Plane::none, 0.35) == fixtures::relative(1, 0.02));
}

TEST_CASE("bending: fewer layers are softer") {
  double before = 0;
  for (const int layers : {2, 3, 4, 6, 8, 12}) {
    const double now = relative(layers);
    CAPTURE(layers);
    CHECK(now > before);
    CHECK(now < 1.02);
    before = now;
  }
}

TEST_CASE("bending: the factor does not depend on the modulus or the spacing of a lattice") {
  const Stencil stencil(FamilyRule::hu_ha_bobaru, 0.01, 3.015, std::nullopt);
  const IsotropicElastic elastic{70e9, nu, 3};
  const OrdinaryState law(elastic, madenci_oterkus_influences, stencil.horizon(), 1, sums_of(stencil, madenci_oterkus_influences, nu));
  // lengths and moduli cancel, to rounding of some hundred terms
  CHECK(relative_bending_stiffness({0.01, std::nullopt, 0, 4}, law, CorrectionKind::energy, stencil) == fixtures::relative(relative(4), 1e-10));
}

TEST_CASE("bending: a beam of four layers has the deflection of beam theory with the calibration, and a sixth more without") {
  constexpr int layers = 4, width = 6, length = 51;
  constexpr double force = 1e3;
  const double h = layers * spacing, b = width * spacing, L = (length - 3.5) * spacing;  // from the edge of the clamped columns to the middle of the load
  const double I = b * h * h * h / 12, G = E / (2 * (1 + nu));
  const double theory = force * L * L * L / (3 * E * I) + force * L / (5.0 / 6 * G * b * h);  // Timoshenko's beam
  const auto sag = [&](const char* calibration) {
    Simulation simulation(cantilever(layers, width, length, calibration, force));
    fixtures::run(simulation);
    return -fixtures::value(simulation, "tip.displacement_z [m]");
  };
  // the clamped end is slightly compliant within the horizon, and the factor is that of a wide plate, not of a beam: together 4.4 %
  CHECK(sag("z") == fixtures::relative(theory, 0.05));
  CHECK(sag("none") > 1.15 * theory);
}

TEST_CASE("bending: the calibration scales every bond stiffness by one factor and does not change strength") {
  const auto made = [](const char* calibration, double modulus) {
    Setup setup = cantilever(4, 6, 20, calibration, 1e3);
    auto& material = std::get<OrdinaryStateSetup>(setup.bodies.front().material);
    material.youngs_modulus = modulus;
    material.flexural_strength = 5e5;
    return make_body(setup.bodies.front());
  };
  const Body calibrated = made("z", E), plain = made("none", E);
  REQUIRE(calibrated.bending);
  CHECK(*calibrated.bending == fixtures::relative(1 / relative(4), 1e-12));  // the same sums
  CHECK_FALSE(plain.bending);
  CHECK(calibrated.failure->stretch == plain.failure->stretch);
  const auto& law = calibrated.internal.ordinary_state()->law();
  CHECK(law.b() == fixtures::relative(*calibrated.bending * plain.internal.ordinary_state()->law().b(), 1e-14));  // one product
}

TEST_CASE("bending: an impossible calibration is rejected with a reason") {
  std::string key;
  CHECK(fixtures::complaint(cantilever(1, 6, 20, "z", 1), key).find("has 1 layers of particles along z") != std::string::npos);
  CHECK(key == "bodies.beam.bending_calibration");
  CHECK(fixtures::complaint(cantilever(4, 6, 51, "x", 1), key).find("remove it, or name the thin direction") != std::string::npos);
}
