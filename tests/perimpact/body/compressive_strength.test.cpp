// Uniaxial compressive strength that a body's deck implies: against the formulas, and the bars measured in docs/theory/damage.md.
#include "perimpact/body/compressive_strength.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "fixtures/tolerance.hpp"

using namespace perimpact;

namespace {

constexpr double E = 2e9, stretch = 1e-3;

struct Options {
  double poissons_ratio = 0.25;
  double hardening = 0;
  CompressionFailure compression = CompressionFailure::none;
  std::optional<double> critical_compression = {};
  std::optional<double> yields = {};
  bool fails = true;
  bool is_plane = false;
};

BodySetup prism(const Options& options) {
  BodySetup body{.name = "prism", .spacing = 0.1};
  body.shape = BoxSolid{options.is_plane ? Vec3d{0.4, 0.8, 0.1} : Vec3d{0.4, 0.4, 0.8}};
  if (options.is_plane) body.plane.index = static_cast<int>(Plane::stress);
  OrdinaryStateSetup material;
  material.youngs_modulus = E, material.poissons_ratio = options.poissons_ratio, material.density = 900;
  if (options.fails) material.critical_stretch = stretch;
  if (options.yields) material.plasticity = PlasticitySetup{.compressive_strength = options.yields};
  body.material = material;
  FailureSetup failure;
  failure.compression.index = static_cast<int>(options.compression);
  failure.critical_compression = options.critical_compression;
  failure.compression_hardening = options.hardening;
  if (options.fails) body.failure = failure;
  return body;
}

std::optional<CompressiveStrength> strength(const Options& options) {
  const BodySetup setup = prism(options);
  return compressive_strength(setup, make_body(setup));
}

constexpr double rounding = 1e-12;

}  // namespace

TEST_CASE("compressive strength: bonds across the load break at E s_c/(ν - α), at free faces at the strength of the measured bars") {
  struct Bar {
    double poissons_ratio, hardening, measured;  // [E s_c], ten particles across: docs/theory/damage.md
  };
  for (const Bar& bar : {Bar{0.2, 0, 3.5}, Bar{0.2, 0.1, 5.5}, Bar{0.25, 0, 2.7}, Bar{0.25, 0.1, 3.7}, Bar{0.3, 0, 2.2}, Bar{0.3, 0.1, 2.8}, Bar{0.35, 0, 1.8},
                         Bar{0.35, 0.1, 2.3}}) {
    const auto found = strength({.poissons_ratio = bar.poissons_ratio, .hardening = bar.hardening});
    CHECK(found->uniform == fixtures::relative(E * stretch / (bar.poissons_ratio - bar.hardening), rounding));
    CHECK(*found->faces == fixtures::relative(bar.measured * E * stretch, 0.03));  // two digits are given
  }
}

TEST_CASE("compressive strength: hardening from Poisson's ratio on leaves the faces only, and more leaves nothing that fails") {
  const auto between = strength({.hardening = 0.3}), beyond = strength({.hardening = 0.4});
  CHECK(std::isinf(between->uniform));
  CHECK(*between->faces == fixtures::relative(E * stretch / (0.37 - 0.3), rounding));
  CHECK(std::isinf(beyond->uniform));
  CHECK(std::isinf(*beyond->faces));
}

TEST_CASE("compressive strength: a limit of bonds in compression governs where it is reached before the body splits") {
  CHECK(strength({.compression = CompressionFailure::symmetric})->uniform == fixtures::relative(E * stretch, rounding));
  CHECK(strength({.compression = CompressionFailure::limit, .critical_compression = 2e-3})->uniform == fixtures::relative(2 * E * stretch, rounding));
  CHECK(strength({.compression = CompressionFailure::limit, .critical_compression = 5e-3})->uniform == fixtures::relative(4 * E * stretch, rounding));
}

TEST_CASE("compressive strength: ice that yields has the strength of its surface, and no more than free faces sustain") {
  const auto weak = strength({.yields = 3 * E * stretch}), strong = strength({.yields = 10 * E * stretch});
  CHECK(weak->uniform == fixtures::relative(3 * E * stretch, rounding));
  CHECK(*weak->faces == fixtures::relative(3 * E * stretch, rounding));
  CHECK(strong->uniform == fixtures::relative(10 * E * stretch, rounding));
  CHECK(*strong->faces == fixtures::relative(E * stretch / 0.12, rounding));
}

TEST_CASE("compressive strength: a body that never fails has none, and the faces of plane bodies are not known") {
  CHECK_FALSE(strength({.fails = false}).has_value());
  CHECK_FALSE(strength({.is_plane = true})->faces.has_value());
}
