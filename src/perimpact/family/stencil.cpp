#include "perimpact/family/stencil.hpp"

#include <algorithm>
#include <cmath>

namespace perimpact {

Stencil::Stencil(FamilyRule rule, double spacing, double horizon_ratio, const std::optional<double>& thickness)
    : spacing_(spacing), horizon_(horizon_ratio * spacing), beyond_horizon_(reach_beyond_horizon(rule)) {
  // in spacings, so that the result does not depend on rounding of the unit
  const double cut = horizon_ratio + beyond_horizon_;
  const int range = static_cast<int>(std::ceil(cut)), layers = thickness ? 0 : range;
  const double cell_volume = spacing * spacing * thickness.value_or(spacing);
  for (int dk = -layers; dk <= layers; ++dk)
    for (int dj = -range; dj <= range; ++dj)
      for (int di = -range; di <= range; ++di) {
        const double distance = std::sqrt(static_cast<double>(di * di + dj * dj + dk * dk));
        const bool bonded = rule == FamilyRule::hu_ha_bobaru ? distance < cut : distance <= cut;
        if (distance == 0 || !bonded) continue;
        const double part = std::min(1.0, horizon_ratio + 0.5 - distance);
        bonds_.push_back({di, dj, dk, distance * spacing, Vec3d{1.0 * di, 1.0 * dj, 1.0 * dk} / distance, part * cell_volume});
        reach_ = std::max({reach_, std::abs(di), std::abs(dj), std::abs(dk)});
      }
}

}  // namespace perimpact
