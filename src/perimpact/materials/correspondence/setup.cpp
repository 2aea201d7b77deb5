#include "perimpact/materials/correspondence/setup.hpp"

#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<CorrespondenceSetup>> CorrespondenceSetup::fields() {
  using S = CorrespondenceSetup;
  static const auto all = with_elastic_fields<S>(
      {poissons_ratio_field<S>("Poisson's ratio ν: an isotropic solid needs -1 < ν < 0.5. Ice is usually 0.25 to 0.35."),
       {"law",
        &S::law,
        "",
        {},
        optional,
        "Stress-strain law at finite strain: hencky (linear in the logarithmic strain) or st-venant-kirchhoff (linear in the Green-Lagrange strain; it softens "
        "in compression to 0.58 of the length)."},
       {"stabilisation",
        &S::stabilisation,
        "",
        {},
        optional,
        "Control of zero-energy modes, to which deformation gradients are blind: bond-level (bonds are compared with the mean gradient of their ends, so that "
        "bending and torsion are not resisted) or, at half the cost, wan or silling (gradient of each end: for strains that are uniform within a horizon; thin "
        "bodies bend several times too stiffly)."},
       {"stabilisation_factor", &S::stabilisation_factor, "1", positive(), optional, "Factor on the stiffness of the stabilisation."},
       influence_field<S>()});
  return all;
}

void CorrespondenceSetup::check(BodyContext& deck) {
  ElasticSetup::check(deck);
  if (deck.body.bending_calibration.as<ThinAxis>() != ThinAxis::none)
    deck.refuse_body("bending_calibration",
                     "bending_calibration scales the stiffness of bonds, but the model correspondence has none; remove it, or use more layers.");
  refuse_surface_correction(name, deck);
  if (!deck.body.published && deck.body.normalisation.as<Normalisation>() == Normalisation::continuum)
    deck.refuse_body("normalisation",
                     "normalisation is continuum, but the model correspondence has the exact energy of uniform strain on every lattice and needs no "
                     "normalisation; remove normalisation.");
}

}  // namespace perimpact
