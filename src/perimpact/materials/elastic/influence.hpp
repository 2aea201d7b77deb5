/// Influence function ω(|ξ|), the weight of a bond in family sums by its length (Silling et al., J. Elast. 88 (2007) 151).
#pragma once

#include <cmath>
#include <numbers>

namespace perimpact {

/// constant: 1.  inverse: δ/|ξ|.  inverse_square: (δ/|ξ|)².  parabolic: 1 up to δ/2, then 4 (r - r²), r = |ξ|/δ.  gaussian: exp(-(r/0.4)²).
/// Beyond δ, where the family of Hu, Ha and Bobaru still has bonds, parabolic is 0; the others continue.
enum class Influence { constant, inverse, inverse_square, parabolic, gaussian };

/// ω |ξ|² [m²], the weight in family sums; finite at |ξ| = 0.
inline double weight_of(Influence influence, double length, double horizon) {
  const double r = length / horizon;
  switch (influence) {
    case Influence::constant:
      return length * length;
    case Influence::inverse:
      return horizon * length;
    case Influence::inverse_square:
      return horizon * horizon;
    case Influence::parabolic:
      return r < 0.5 ? length * length : std::fmax(0.0, 4 * (r - r * r)) * length * length;
    case Influence::gaussian:
      return std::exp(-6.25 * r * r) * length * length;
  }
  return 0;
}

/// Weighted volume m = ∫ ω |ξ|² dV over the full horizon [m⁵]; in 2-D over a disc of that thickness. Simpson's rule: exact where ω is a power, to 1e-12
/// for the others (parabolic has its kink at a node).
inline double weighted_volume(Influence influence, double horizon, int dimension, double thickness) {
  constexpr int intervals = 2000;
  double sum = 0;
  for (int n = 0; n <= intervals; ++n) {
    const double r = horizon * n / intervals;
    const double shell = dimension == 3 ? 4 * std::numbers::pi * r * r : 2 * std::numbers::pi * r * thickness;
    sum += (n == 0 || n == intervals ? 1 : n % 2 ? 4 : 2) * weight_of(influence, r, horizon) * shell;
  }
  return sum * horizon / intervals / 3;
}

}  // namespace perimpact
