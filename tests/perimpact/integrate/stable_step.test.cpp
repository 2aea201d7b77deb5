#include "perimpact/integrate/stable_step.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/integrate/stiffest_mode.hpp"
#include "perimpact/particles/advance.hpp"
#include "perimpact/plane_waves.hpp"

using namespace perimpact;
using fixtures::Model;

namespace {
/// In units of Δ/√(E/ρ), as the table of the physics notes 2.3 has it.
double in_spacings(double step) { return step * std::sqrt(fixtures::youngs_modulus / fixtures::density) / 0.001; }

Body continuum_body(FamilyRule family, double nu) {
  return fixtures::body({.poissons_ratio = nu, .correction = SurfaceCorrection::none, .family = family, .normalisation = Normalisation::continuum});
}
}  // namespace

TEST_CASE("stable step: the limit of the infinite lattice is that of the Bloch analysis, and that of a body without corrections is close") {
  struct Row {
    FamilyRule family;
    double nu, exact;
  };
  // Table 2.3 of the physics notes, printed with four digits; its wave vectors are not ours, hence half a per cent
  for (const Row& row :
       {Row{FamilyRule::madenci_oterkus, 0.25, 1.826}, Row{FamilyRule::madenci_oterkus, 0.3, 1.856}, Row{FamilyRule::madenci_oterkus, 0.4, 1.856},
        Row{FamilyRule::hu_ha_bobaru, 0.25, 1.802}, Row{FamilyRule::hu_ha_bobaru, 0.3, 1.824}, Row{FamilyRule::hu_ha_bobaru, 0.4, 1.805}}) {
    CAPTURE(row.nu);
    const Body body = continuum_body(row.family, row.nu);
    const double waves = fixtures::plane_wave_limit(body);
    CHECK(in_spacings(waves) == fixtures::relative(row.exact, 0.005));
    // without a correction surfaces are softer than the interior: the limit is that of the lattice, and little more since waves must fit into the body
    CHECK(exact_stable_step(body) > 0.999 * waves);
    CHECK(exact_stable_step(body) < 1.1 * waves);
  }
}

TEST_CASE("stable step: the estimate of Silling and Askari is that of the reference table, for an interior particle") {
  CHECK(in_spacings(silling_askari_step(continuum_body(FamilyRule::madenci_oterkus, 0.25))) == fixtures::relative(0.924, 0.001));  // three digits
  CHECK(in_spacings(silling_askari_step(continuum_body(FamilyRule::hu_ha_bobaru, 0.25))) == fixtures::relative(0.888, 0.001));
}

TEST_CASE("stable step: the estimate is that of the stiffest particle of a plain loop, though equal packs are summed once") {
  for (const Model model : {Model::ordinary_state, Model::bond_based, Model::correspondence})
    for (const Vec3d& size : {Vec3d{0.09, 0.02, 0.02}, Vec3d{0.032, 0.03, 0.03}}) {
      BodySetup setup = fixtures::body_setup({.size = size, .model = model});
      setup.holes = {{.name = "hole", .shape = BoxSolid{.size = {0.009, 0.003, 1}}, .position = {0.01, 0, 0}}};
      const Body body = make_body(setup);
      double stiffest = 0;
      for (const std::uint32_t slot : body.particles.slot_of()) {
        double sum = 0;
        body.family.for_each_bond(slot, [&](const FamilyBond& bond) { sum += body.internal.bond_stiffness(slot, bond) * bond.volume; });
        stiffest = fixtures::larger(stiffest, sum);
      }
      CHECK(silling_askari_step(body) == std::sqrt(2 * fixtures::density / stiffest));  // bitwise: the same sums
    }
}

TEST_CASE("stable step: the lower bound for a body is longer than the estimate and no longer than its stiffest mode permits") {
  const Body solid = fixtures::body({.size = {0.012, 0.012, 0.012}});
  const double own = own_stable_step(solid, {}), estimate = silling_askari_step(solid);
  CHECK(own > 1.1 * estimate);
  CHECK(own < 2 / std::sqrt(stiffest_mode(solid, 80)));
  // contact as stiff as all bonds of the stiffest particle halves the square of the estimate; the bound must not be more lenient than that of its own modes
  const double all_bonds = 2 * fixtures::density / (estimate * estimate);
  const ShortRange::Bound contact{.stiffness = all_bonds};
  CHECK(silling_askari_step(solid, contact) == fixtures::relative(estimate / std::sqrt(2.0), 1e-12));  // the same sums
  const double squared = 4 / (own * own) + 4 / (estimate * estimate);                                  // Weyl: both at their stiffest
  CHECK(own_stable_step(solid, contact) == fixtures::relative(2 / std::sqrt(squared), 1e-12));
}

TEST_CASE("stable step: below the exact limit a perturbed block conserves its energy, above it the energy grows") {
  for (const double nu : {0.25, 0.3}) {
    const auto energy_after = [&](double share) {
      Body solid = fixtures::body({.size = {0.012, 0.012, 0.012}, .poissons_ratio = nu});
      const double dt = share * silling_askari_step(solid);
      std::vector<double> travel(travel_blocks(solid.particles));
      fixtures::shake(solid, 1e-9);
      double energy = solid.internal.evaluate_with_energy(solid.particles, solid.family);
      const double first = energy;
      for (int step = 0; step < 400; ++step) {
        advance(solid.particles, dt, travel);
        energy = solid.internal.evaluate_with_energy(solid.particles, solid.family);
      }
      return (energy + solid.motion(dt).kinetic_energy) / first;
    };
    // with velocities interpolated to the end of the step, the energy of an oscillator swings by (ω dt)²/4 < 1/4 at ω dt < 1
    CHECK(energy_after(0.9) == fixtures::relative(1.0, 0.25));
    CHECK_FALSE(energy_after(2.6) <
                100);  // or not a number by then. Corners, where fewer bonds pull but with larger factors, go first; 2.05 is the interior's limit
  }
}
