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
       "Thickness of the ice in bending, in place of layers. Where both are absent, the body's thinnest direction."},
      {"strain_rate", &S::strain_rate, "1/s", positive(), optional,
       "Strain rate of the compressive strength that the ice gives to plasticity, from 1e-7 to 1e-3 1/s; 1e-3 for impacts."},
      {"air_volume", &S::air_volume, "1", between(0, 0.25), optional, "Air volume fraction, which with the brine lowers the compressive strength."},
      {"structure",
       &S::structure,
       "",
       {},
       optional,
       "Of the compressive strength: columnar ice loaded along the sheet, columnar-vertical for columnar ice loaded along its columns, or granular ice."}};
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
  if (strain_rate) apply_strain_rate(material, brine, deck);
  if (!thickness) return;
  if (!deck.body.spacing) deck.refuse("ice.thickness", "thickness is given, but a body from a file has no spacing from which layers follow; give layers.");
  if (!material.flexural_strength) deck.refuse("ice.thickness", "thickness applies to flexural_strength only, which is not given; remove it.");
  const int own_layers = std::max(2, static_cast<int>(std::lround(*thickness / *deck.body.spacing)));
  if (material.layers.value_or(own_layers) != own_layers)
    deck.refuse("layers", fmt::format("layers is {}, but ice {} m thick has {} layers of {} m; remove one of the two.", *material.layers, *thickness,
                                      own_layers, *deck.body.spacing));
  material.layers = own_layers;
}

void IceSetup::apply_strain_rate(ElasticSetup& material, double brine, const BodyContext& deck) const {
  if (*strain_rate < slowest_crushing || *strain_rate > fastest_crushing)
    deck.refuse("ice.strain_rate",
                fmt::format("strain_rate is {:.4g} 1/s, but compressive strength was measured from {:.0e} to {:.0e} 1/s; {}, or give "
                            "plasticity.compressive_strength.",
                            *strain_rate, slowest_crushing, fastest_crushing,
                            *strain_rate > fastest_crushing ? "give 1e-3 for faster ice, which is brittle and no stronger" : "give a rate in this range"));
  if (!material.plasticity)
    deck.refuse("ice.strain_rate", "strain_rate gives a compressive strength, but the material does not yield; add plasticity: {}, or remove strain_rate.");
  PlasticitySetup& plasticity = *material.plasticity;
  if (plasticity.compressive_strength) return;
  const auto surface = plasticity.surface.as<YieldSurface>();
  if (surface != YieldSurface::von_mises && surface != YieldSurface::riska_frederking)
    deck.refuse(
        "ice.strain_rate",
        fmt::format("strain_rate gives a compressive strength, but surface: {} has its own; remove one of the two (without surface, the one of Riska and "
                    "Frederking is scaled).",
                    plasticity.surface.word()));
  const auto kind = structure.as<IceStructure>();
  const double porosity = brine + air_volume, most = crushing_fit(kind).most_porosity;
  if (porosity >= most)
    deck.refuse("ice",
                fmt::format("ice with a volume fraction of {:.3g} of brine and air has no compressive strength left, which {} ice loses at {}; use colder, "
                            "less saline or less porous ice, or give plasticity.compressive_strength.",
                            porosity, structure.word(), most));
  plasticity.compressive_strength = ice_compressive_strength(kind, porosity, *strain_rate);
}

}  // namespace perimpact
