// Ice in a deck: what it sets, what overrides it, and what is refused.
#include <doctest/doctest.h>

#include <string>

#include "io/deck/fixtures.hpp"

#include "fixtures/tolerance.hpp"

using namespace perimpact;

namespace {

const std::string steel = "{model: ordinary-state, youngs_modulus: 191 GPa, poissons_ratio: 0.25, density: 8000}";

std::string with_material(const std::string& material) { return fixtures::plate_with(steel, material); }

ElasticSetup read(const std::string& material) { return fixtures::read(with_material(material)).setup.bodies.front().elastic(); }

}  // namespace

TEST_CASE("ice: temperature and salinity give modulus and flexural strength") {
  const ElasticSetup ice = read("{model: bond-based, density: 910, ice: {temperature: -5, salinity: 5}}");
  // the values of tests/perimpact/materials/ice/ice.test.cpp
  CHECK(*ice.youngs_modulus == fixtures::relative(7.18024e9, 1e-5));
  CHECK(*ice.flexural_strength == fixtures::relative(0.46137e6, 1e-4));
  CHECK_FALSE(ice.layers);
}

TEST_CASE("ice: kelvin, degrees Fahrenheit and parts per thousand are converted") {
  const ElasticSetup ice = read("{model: bond-based, density: 910, ice: {temperature: 23 degF, salinity: 5 g/kg}}");
  CHECK(*ice.ice->temperature == fixtures::relative(-5, 1e-12));
  CHECK(*read("{model: bond-based, density: 910, ice: {temperature: 268.15 K, salinity: 5}}").ice->temperature == fixtures::relative(-5, 1e-12));
  CHECK(*ice.youngs_modulus == fixtures::relative(7.18024e9, 1e-5));
}

TEST_CASE("ice: values given in the deck take precedence") {
  const ElasticSetup ice = read("{model: bond-based, density: 910, youngs_modulus: 1.8 GPa, flexural_strength: 0.7 MPa, ice: {brine_volume: 0.05}}");
  CHECK(*ice.youngs_modulus == 1.8e9);
  CHECK(*ice.flexural_strength == 0.7e6);
  CHECK_FALSE(read("{model: bond-based, density: 910, critical_stretch: 0.001, ice: {brine_volume: 0.05}}").flexural_strength);
}

TEST_CASE("ice: the thickness determines the layers in bending") {
  CHECK(*read("{model: bond-based, density: 910, ice: {brine_volume: 0.05, thickness: 9 mm}}").layers == 9);  // of 1 mm
}

TEST_CASE("ice: a strain rate gives plasticity its compressive strength, unless the deck gives one") {
  const auto strength = [](const std::string& ice, const std::string& plasticity) {
    return read("{model: bond-based, density: 910, ice: {" + ice + "}, plasticity: {" + plasticity + "}}").plasticity->compressive_strength;
  };
  // by hand, as in tests/perimpact/materials/ice/ice.test.cpp
  CHECK(*strength("brine_volume: 0.03, strain_rate: 1e-3", "") == fixtures::relative(5.39648e6, 1e-5));
  CHECK(*strength("brine_volume: 0.02, air_volume: 0.01, strain_rate: 1e-3 1/s", "") == fixtures::relative(5.39648e6, 1e-5));
  CHECK(*strength("brine_volume: 0.07, strain_rate: 1e-3, structure: granular", "") == fixtures::relative(5.36001e6, 1e-5));
  CHECK(*strength("brine_volume: 0.05, strain_rate: 1e-3, structure: columnar-vertical", "") == fixtures::relative(17.5021e6, 1e-5));
  for (const char* surface : {"surface: von-mises", "surface: riska-frederking"})  // the two that are scaled
    CHECK(*strength("brine_volume: 0.03, strain_rate: 1e-3", surface) == fixtures::relative(5.39648e6, 1e-5));
  // at -5 degC and 5 g/kg 51.845 parts in a thousand: 37 0.218776 (1 - √(51.845/270)) = 37 0.218776 0.561803
  CHECK(*strength("temperature: -5, salinity: 5, strain_rate: 1e-3", "") == fixtures::relative(4.54765e6, 1e-5));
  CHECK(*strength("brine_volume: 0.03, strain_rate: 1e-3", "compressive_strength: 2.3 MPa") == 2.3e6);
  CHECK_FALSE(strength("brine_volume: 0.03", ""));
}

TEST_CASE("ice: a strain rate outside of the tests, without plasticity or beside a surface with a strength is refused, as is ice that is all pores") {
  const auto says = [](const std::string& material, const char* words) {
    const std::string complaint = fixtures::complaint(with_material("{model: bond-based, density: 910, " + material + "}"));
    CAPTURE(complaint);
    CHECK(complaint.find(words) != std::string::npos);
  };
  says("ice: {brine_volume: 0.05, strain_rate: 0.1}, plasticity: {}",
       "strain_rate is 0.1 1/s, but compressive strength was measured from 1e-07 to 1e-03 1/s; give 1e-3 for faster ice, which is brittle and no stronger, or "
       "give plasticity.compressive_strength.");
  says("ice: {brine_volume: 0.05, strain_rate: 1e-8}, plasticity: {}", "give a rate in this range, or give plasticity.compressive_strength.");
  says("ice: {brine_volume: 0.05, strain_rate: 1e-3}", "but the material does not yield; add plasticity: {}, or remove strain_rate.");
  says("ice: {brine_volume: 0.05, strain_rate: 1e-3}, plasticity: {surface: kierkegaard}", "but surface: kierkegaard has its own; remove one of the two");
  says("ice: {brine_volume: 0.2, air_volume: 0.08, strain_rate: 1e-3}, plasticity: {}",
       "a volume fraction of 0.28 of brine and air has no compressive strength left, which columnar ice loses at 0.27;");
}

TEST_CASE("ice: incomplete or redundant properties and ice without strength are refused") {
  const auto complaint = [](const std::string& material) { return fixtures::complaint(with_material(material)); };
  const auto says = [&](const std::string& material, const char* words) {
    CAPTURE(complaint(material));
    CHECK(complaint(material).find(words) != std::string::npos);
  };
  says("{model: bond-based, density: 910}", "youngs_modulus is missing; give it, or ice");
  says("{model: bond-based, density: 910, ice: {temperature: -5}}", "either brine_volume or both temperature and salinity");
  says("{model: bond-based, density: 910, ice: {temperature: -5, salinity: 5, brine_volume: 0.05}}", "either brine_volume or both");
  says("{model: bond-based, density: 910, ice: {temperature: -0.5, salinity: 5}}", "has a brine volume of 0.495");
  says("{model: bond-based, density: 910, ice: {temperature: 2, salinity: 5}}", "temperature");
  says("{model: bond-based, density: 910, layers: 4, ice: {brine_volume: 0.05, thickness: 9 mm}}", "layers is 4, but ice 0.009 m thick has 9 layers");
  says("{model: bond-based, density: 910, critical_stretch: 0.1, ice: {brine_volume: 0.05, thickness: 9 mm}}", "applies to flexural_strength only");
}

TEST_CASE("bending_calibration: refused without layers of bonds in bending") {
  const auto says = [&](const char* old_text, const char* new_text, const char* words) {
    const std::string complaint = fixtures::complaint(fixtures::plate_with(old_text, new_text));
    CAPTURE(complaint);
    CHECK(complaint.find(words) != std::string::npos);
  };
  says("    spacing: 0.001\n", "    spacing: 0.001\n    plane: stress\n    bending_calibration: z\n", "bends in x and y only");
  says("    material: {model: ordinary-state, ", "    bending_calibration: z\n    material: {model: correspondence, ", "the model correspondence has none");
}
