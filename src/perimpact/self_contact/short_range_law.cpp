#include "perimpact/self_contact/short_range_law.hpp"

#include <numbers>

#include "base/contract.hpp"

namespace perimpact {

double ShortRangeLaw::stiffness(const IsotropicElastic& elastic, double horizon, double thickness) const {
  constexpr double pi = std::numbers::pi;
  const double kappa = elastic.bulk_modulus(), cubed = horizon * horizon * horizon;
  const double c = elastic.dimension == 3 ? 18 * kappa / (pi * cubed * horizon) : 12 * kappa / (pi * thickness * cubed);
  return stiffness_factor * c / horizon;
}

namespace {

/// -ln(e)/2 for the given damping ratio.
double half_decrement(double damping_ratio) {
  if (damping_ratio < 1) {
    const double phi = std::asin(damping_ratio);
    return (std::numbers::pi / 2 - phi) * std::tan(phi);
  }
  const double psi = std::acosh(damping_ratio);
  return psi > 0 ? psi / std::tanh(psi) : 1;
}

}  // namespace

double damping_ratio_of(double restitution) {
  EXPECTS(restitution > 0 && restitution <= 1);
  const double wanted = -std::log(restitution) / 2;
  if (wanted == 0) return 0;
  double low = 0, high = 1;
  while (half_decrement(high) < wanted) high *= 2;
  for (int halving = 0; halving < 60; ++halving) {  // to rounding: the decrement increases with the damping
    const double middle = 0.5 * (low + high);
    (half_decrement(middle) < wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace perimpact
