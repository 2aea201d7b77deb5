/// Family sums of uniform strain for an interior particle of a lattice, with the weights of a material.
#pragma once

#include "perimpact/family/stencil.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state.hpp"

namespace perimpact {

/// `poissons_ratio`: in 2-D that of the plane.
inline FamilySums sums_of(const Stencil& stencil, const Influences& influences, double poissons_ratio) {
  FamilySums sums{};
  for (const StencilBond& bond : stencil.bonds()) {
    const double stretch = stretch_of_unit_pull(bond.direction, 0, poissons_ratio);
    const BondWeights weights = influences.of(bond.length, stencil.horizon());
    sums.volume += bond.volume;
    sums.weighted += weights.dilatation * bond.volume;
    sums.dilatation += bond.direction.x * bond.direction.x * weights.dilatation * bond.volume;
    sums.energy += stretch * stretch * weights.stretch * bond.volume;
  }
  return sums;
}

}  // namespace perimpact
