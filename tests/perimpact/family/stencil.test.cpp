#include "perimpact/family/stencil.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "perimpact/material/ordinary_state.hpp"

using namespace perimpact;

namespace {
constexpr double spacing = 0.001, ratio = 3.015;
}

TEST_CASE("stencil: families have the published numbers of bonds and share of the horizon's volume") {
  const double sphere = 4.0 / 3.0 * std::numbers::pi * ratio * ratio * ratio * spacing * spacing * spacing;
  const Stencil published(FamilyRule::madenci_oterkus, spacing, ratio), improved(FamilyRule::hu_ha_bobaru, spacing, ratio);
  CHECK(published.size() == 122);
  CHECK(improved.size() == 178);
  // physics notes, table 1.6, three decimals
  CHECK(published.sums(0.25).volume / sphere == doctest::Approx(0.903).epsilon(0.001));
  CHECK(improved.sums(0.25).volume / sphere == doctest::Approx(1.022).epsilon(0.001));
}

TEST_CASE("stencil: with continuum constants the lattice has the energies of the published table") {
  // W_lattice/W_classical of table 1.6, three decimals: uniform dilatation, uniaxial strain, shear; bond-based, ν = 1/4
  struct Row {
    FamilyRule rule;
    double dilatation, uniaxial, shear;
  };
  for (const Row& row : {Row{FamilyRule::madenci_oterkus, 0.890, 0.854, 0.943}, Row{FamilyRule::hu_ha_bobaru, 1.059, 1.068, 1.046}}) {
    const IsotropicElastic elastic{1.0, 0.25};
    const Stencil stencil(row.rule, spacing, ratio);
    const OrdinaryState material(elastic, stencil.horizon(), std::nullopt);
    double dilatation = 0, uniaxial = 0, shear = 0;
    for (const StencilBond& bond : stencil.bonds()) {
      const double w = material.bond_stiffness() / 4 * bond.length * bond.volume;
      const Vec3d n = bond.direction;
      dilatation += w;
      uniaxial += w * n.x * n.x * n.x * n.x;
      shear += w * n.x * n.x * n.y * n.y;
    }
    CHECK(dilatation / (4.5 * elastic.bulk_modulus()) == doctest::Approx(row.dilatation).epsilon(0.001));
    CHECK(uniaxial / (elastic.p_wave_modulus() / 2) == doctest::Approx(row.uniaxial).epsilon(0.001));
    CHECK(shear / (elastic.shear_modulus() / 2) == doctest::Approx(row.shear).epsilon(0.001));
  }
}

TEST_CASE("stencil: normalised on the lattice, a pull along an axis has exactly its Young's modulus and uniform strain its dilatation") {
  for (const FamilyRule rule : {FamilyRule::madenci_oterkus, FamilyRule::hu_ha_bobaru})
    for (const double nu : {-0.2, 0.2, 0.25, 0.3, 0.4, 0.49}) {
      CAPTURE(nu);
      const IsotropicElastic elastic{191e9, nu};
      const Stencil stencil(rule, spacing, ratio);
      const StencilSums sums = stencil.sums(nu);
      const OrdinaryState material(elastic, stencil.horizon(), LatticeSums{sums.dilatation, sums.energy});
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double theta = 0, bonds = 0;
        for (const StencilBond& bond : stencil.bonds()) {
          const double stretch = stretch_of_unit_pull(bond, axis, nu);
          theta += material.d() * stencil.horizon() * stretch * bond.volume;
          bonds += material.b() * stencil.horizon() * stretch * stretch * bond.length * bond.volume;
        }
        CHECK(theta == doctest::Approx(1 - 2 * nu).epsilon(1e-10));  // sums of 178 terms; at ν = 0.49 a difference of 0.02
        CHECK(material.a() * theta * theta + bonds == doctest::Approx(elastic.youngs_modulus / 2).epsilon(1e-10));
      }
    }
}

TEST_CASE("stencil: opposite bonds mirror one another in its order") {
  const Stencil stencil(FamilyRule::hu_ha_bobaru, spacing, ratio);
  for (std::size_t b = 0; b < stencil.size(); ++b) {
    const StencilBond &bond = stencil.bonds()[b], &opposite = stencil.bonds()[stencil.size() - 1 - b];
    CHECK(bond.di == -opposite.di);
    CHECK(bond.dj == -opposite.dj);
    CHECK(bond.dk == -opposite.dk);
  }
}
