#include "perimpact/family/stencil.hpp"

#include <algorithm>
#include <cmath>

namespace perimpact {

Stencil::Stencil(FamilyRule rule, double spacing, double horizon_ratio) : spacing_(spacing), horizon_(horizon_ratio * spacing) {
  // in spacings, so that the choice does not depend on rounding of the unit
  const double cut = rule == FamilyRule::hu_ha_bobaru ? horizon_ratio + 0.5 : horizon_ratio;
  const int range = static_cast<int>(std::ceil(cut));
  for (int dk = -range; dk <= range; ++dk)
    for (int dj = -range; dj <= range; ++dj)
      for (int di = -range; di <= range; ++di) {
        const double distance = std::sqrt(static_cast<double>(di * di + dj * dj + dk * dk));
        const bool bonded = rule == FamilyRule::hu_ha_bobaru ? distance < cut : distance <= cut;
        if (distance == 0 || !bonded) continue;
        const double part = std::min(1.0, horizon_ratio + 0.5 - distance);
        bonds_.push_back({di, dj, dk, distance * spacing, Vec3d{1.0 * di, 1.0 * dj, 1.0 * dk} / distance, part * spacing * spacing * spacing});
        reach_ = std::max({reach_, std::abs(di), std::abs(dj), std::abs(dk)});
      }
}

StencilSums Stencil::sums(double poissons_ratio) const {
  StencilSums sums{};
  for (const StencilBond& bond : bonds_) {
    const double stretch = stretch_of_unit_pull(bond, 0, poissons_ratio);
    sums.volume += bond.volume;
    sums.dilatation += bond.direction.x * bond.direction.x * bond.volume;
    sums.energy += stretch * stretch * bond.length * bond.volume;
  }
  return sums;
}

}  // namespace perimpact
