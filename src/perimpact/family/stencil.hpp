/// Stencil: family of an interior lattice particle, with the partial volumes of its neighbours (volume correction).
#pragma once

#include <optional>
#include <vector>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/particles/lattice.hpp"

namespace perimpact {

/// One bond of the interior family.
struct StencilBond {
  int di, dj, dk;
  double length;    ///< [m] |ξ|
  Vec3d direction;  ///< ξ/|ξ|
  double volume;    ///< [m³] v V: partial volume of the neighbour within the horizon
};

/// Linearised stretch of a bond under unit uniaxial strain along the lattice axis p with lateral contraction ν:
/// s = n_p² - ν (1 - n_p²).
inline double stretch_of_unit_pull(const Vec3d& direction, std::size_t p, double poissons_ratio) {
  const double np2 = direction[p] * direction[p];
  return np2 - poissons_ratio * (1 - np2);
}

/// Length by which bonds may exceed the horizon, over the mean size of both particles (Stencil).
constexpr double reach_beyond_horizon(FamilyRule rule) { return rule == FamilyRule::hu_ha_bobaru ? 0.5 : 0; }

/// Partial volumes follow the line v = (δ + Δ/2 - |ξ|)/Δ, at most 1. Hu, Ha and Bobaru (Comput. Methods Appl. Mech. Eng. 217 (2012) 247)
/// let it decrease to 0 at |ξ| = δ + Δ/2; Madenci and Oterkus truncate it at |ξ| = δ, where it is one half.
/// Bonds are sorted by plane, row and column, so that a sweep reads memory sequentially.
class Stencil {
 public:
  /// `thickness` [m]: of a plane body, whose stencil lies in x and y.
  Stencil(FamilyRule rule, double spacing, double horizon_ratio, const std::optional<double>& thickness = {});

  const std::vector<StencilBond>& bonds() const { return bonds_; }
  std::size_t size() const { return bonds_.size(); }
  double horizon() const { return horizon_; }                ///< [m] δ
  double beyond_horizon() const { return beyond_horizon_; }  ///< in spacings, by which bonds may exceed the horizon
  double spacing() const { return spacing_; }                ///< [m] Δ
  int reach() const { return reach_; }                       ///< in cells

 private:
  double spacing_, horizon_, beyond_horizon_;
  int reach_ = 0;
  std::vector<StencilBond> bonds_;
};

}  // namespace perimpact
