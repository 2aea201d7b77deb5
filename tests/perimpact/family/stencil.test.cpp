#include "perimpact/family/stencil.hpp"

#include <doctest/doctest.h>

using namespace perimpact;

namespace {
constexpr double spacing = 0.001, ratio = 3.015;
}

TEST_CASE("stencil: families have the published numbers of bonds, in 3-D and 2-D") {
  CHECK(Stencil(FamilyRule::madenci_oterkus, spacing, ratio).size() == 122);
  CHECK(Stencil(FamilyRule::hu_ha_bobaru, spacing, ratio).size() == 178);
  CHECK(Stencil(FamilyRule::madenci_oterkus, spacing, ratio, 0.002).size() == 28);
  CHECK(Stencil(FamilyRule::hu_ha_bobaru, spacing, ratio, 0.002).size() == 36);
}

TEST_CASE("stencil: opposite bonds are mirrored in its order") {
  const Stencil stencil(FamilyRule::hu_ha_bobaru, spacing, ratio);
  for (std::size_t b = 0; b < stencil.size(); ++b) {
    const StencilBond &bond = stencil.bonds()[b], &opposite = stencil.bonds()[stencil.size() - 1 - b];
    CHECK(bond.di == -opposite.di);
    CHECK(bond.dj == -opposite.dj);
    CHECK(bond.dk == -opposite.dk);
  }
}
