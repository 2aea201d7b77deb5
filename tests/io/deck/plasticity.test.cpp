// What a deck may say of plasticity, and what contradicts it.
#include <cmath>

#include "fixtures/tolerance.hpp"
#include "io/deck/fixtures.hpp"

using fixtures::complaint;
using fixtures::read;

namespace {

/// A deck whose plate has this material.
std::string plate_of(const std::string& material, const std::string& more = "") {
  std::string text = fixtures::plate_with("    spacing:", more + "    spacing:");
  const std::string old = "{model: ordinary-state, youngs_modulus: 191 GPa, poissons_ratio: 0.25, density: 8000}";
  return text.replace(text.find(old), old.size(), "{youngs_modulus: 1.8 GPa, density: 900, " + material + "}");
}

}  // namespace

TEST_CASE("plasticity: a deck gives a surface by name or a strength, and every default") {
  const auto of = [](const std::string& text) { return read(text).setup.bodies[0].elastic().plasticity.value(); };
  CHECK(of(plate_of("model: bond-based, plasticity: {}")).surface.word() == "riska-frederking");
  CHECK(of(plate_of("model: ordinary-state, plasticity: {surface: kierkegaard}")).surface.word() == "kierkegaard");
  const perimpact::PlasticitySetup all =
      of(plate_of("model: bond-based, plasticity: {compressive_strength: 2.3 MPa, failure_strain: 0.02, failure_width: 2, failure_pressure: 0.5}"));
  CHECK(all.compressive_strength.value() == 2.3e6);
  CHECK(all.failure_strain == 0.02);
  CHECK(all.failure_width == 2);
  CHECK(all.failure_pressure == 0.5);
  CHECK(!all.friction_angle);
  const auto angle = of(plate_of("model: bond-based, critical_stretch: 3e-4, plasticity: {friction_angle: 30 deg}")).friction_angle;
  CHECK(angle.value() == fixtures::relative(std::acos(-1.0) / 6, 1e-12));
  CHECK(complaint(plate_of("model: bond-based, critical_stretch: 3e-4, plasticity: {friction_angle: 90 deg}"))
            .find("friction_angle is \"90 deg\", but it must be") != std::string::npos);
  CHECK(complaint(plate_of("model: bond-based, plasticity: {surface: von-mises, compressive_strength: 2 MPa}")) == "");
  CHECK(complaint(plate_of("model: bond-based, plasticity: {surface: riska-frederking, compressive_strength: 2 MPa}")) == "");  // as in run.json
  CHECK(!read(fixtures::plate).setup.bodies[0].elastic().plasticity);
}

TEST_CASE("plasticity: what contradicts it is refused with a sentence") {
  CHECK(complaint(plate_of("model: correspondence, plasticity: {}"))
            .ends_with("plasticity is for the models ordinary-state and bond-based, but the model is correspondence; change the model, or remove plasticity."));
  CHECK(complaint(plate_of("model: linear-peridynamic-solid, plasticity: {}")).find("but the model is linear-peridynamic-solid;") != std::string::npos);
  CHECK(complaint(plate_of("model: bond-based, plasticity: {compressive_strength: -2 MPa}"))
            .find("compressive_strength is \"-2 MPa\", but it must be above 0.") != std::string::npos);
  CHECK(complaint(plate_of("model: bond-based, plasticity: {surface: kierkegaard, compressive_strength: 2 MPa}"))
            .ends_with("compressive_strength is given beside surface: kierkegaard, which has its own strength; remove one of the two (without surface, the one "
                       "of Riska and Frederking is scaled)."));
  CHECK(complaint(plate_of("model: bond-based, plasticity: {surface: von-mises}"))
            .ends_with("surface is von-mises, which has no strength of its own; give compressive_strength."));
  CHECK(complaint(plate_of("model: bond-based, flexural_strength: 3 MPa, plasticity: {compressive_strength: 2 MPa}"))
            .ends_with("the compressive strength of 2e+06 Pa is not above the flexural_strength of 3e+06 Pa, so the body would yield before it breaks in "
                       "bending; give a larger compressive_strength, or a smaller flexural_strength."));
  CHECK(complaint(plate_of("model: bond-based, plasticity: {friction_angle: 30 deg}"))
            .ends_with("friction_angle is for ice that has failed, but bonds of this material never break; give critical_stretch, fracture_energy or "
                       "flexural_strength, or remove friction_angle."));
  CHECK(complaint(plate_of("model: bond-based, plasticity: {}", "    plane: stress\n"))
            .ends_with("plasticity needs all three normal stresses, but the body is of plane stress; write plane: none, or remove plasticity."));
  const std::string breaks = "model: bond-based, critical_stretch: 3e-4, plasticity: {}";
  CHECK(complaint(plate_of(breaks, "    failure: {compression: symmetric}\n"))
            .ends_with("compression is symmetric, but a material with plasticity yields under pressure in place of breaking; remove one of the two."));
  CHECK(complaint(plate_of(breaks, "    failure: {compression_hardening: 0.1}\n"))
            .ends_with("compression_hardening is given beside plasticity, which has its own limit of bonds under pressure; remove one of the two."));
}
