#include "perimpact/materials/linear_solid/setup.hpp"

#include "perimpact/deck_model/deck_context.hpp"

namespace perimpact {

std::span<const Field<LinearSolidSetup>> LinearSolidSetup::fields() {
  static const auto all = with_elastic_fields<LinearSolidSetup>({poissons_ratio_field<LinearSolidSetup>(), influence_field<LinearSolidSetup>()});
  return all;
}

void LinearSolidSetup::check(BodyContext& deck) {
  ElasticSetup::check(deck);
  refuse_surface_correction(name, deck);
}

}  // namespace perimpact
