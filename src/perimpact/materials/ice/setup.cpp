#include "perimpact/materials/ice/setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/materials/ice/ice.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<IceSetup>> IceSetup::fields() {
  using S = IceSetup;
  static const Field<S> all[] = {
      {"temperature", &S::temperature, "degC", between(-22.9, -0.5), optional, "Temperature of the ice, averaged over its thickness."},
      {"salinity", &S::salinity, "g/kg", between(0, 35), optional, "Salinity of the ice; 0 is freshwater ice."},
      {"brine_volume", &S::brine_volume, "1", between(0, 0.25), optional,
       "In place of temperature and salinity: brine volume fraction, 0.05 for 50 parts per thousand."},
      {"thickness", &S::thickness, "m", positive(), optional,
       "Thickness of the ice in bending, in place of layers. Where both are absent, the body's thinnest direction."}};
  return all;
}

void IceSetup::apply(ElasticSetup& material, const BodyContext& deck) const {
  const bool is_whole = temperature && salinity, is_half = temperature.has_value() != salinity.has_value();
  if (is_half || (brine_volume && is_whole) || (!brine_volume && !is_whole))
    deck.refuse("ice", "ice needs either brine_volume or both temperature and salinity; give one or the other.");
  const double brine = brine_volume ? *brine_volume : perimpact::brine_volume(*salinity, *temperature);
  constexpr double most_brine = 0.25;  // the modulus formula vanishes at 0.256
  if (brine > most_brine)
    deck.refuse("ice", fmt::format("ice of salinity {} g/kg at {} degC has a brine volume of {:.3g}, and its strength is negligible above {}; use colder or "
                                   "less saline ice.",
                                   *salinity, *temperature, brine, most_brine));
  if (!material.youngs_modulus) material.youngs_modulus = ice_youngs_modulus(brine);
  if (!material.may_fail()) material.flexural_strength = ice_flexural_strength(brine);
  if (!thickness) return;
  if (!deck.body.spacing) deck.refuse("ice.thickness", "thickness is given, but a body from a file has no spacing from which layers follow; give layers.");
  if (!material.flexural_strength) deck.refuse("ice.thickness", "thickness applies to flexural_strength only, which is not given; remove it.");
  const int own_layers = std::max(2, static_cast<int>(std::lround(*thickness / *deck.body.spacing)));
  if (material.layers.value_or(own_layers) != own_layers)
    deck.refuse("layers", fmt::format("layers is {}, but ice {} m thick has {} layers of {} m; remove one of the two.", *material.layers, *thickness,
                                      own_layers, *deck.body.spacing));
  material.layers = own_layers;
}

}  // namespace perimpact
