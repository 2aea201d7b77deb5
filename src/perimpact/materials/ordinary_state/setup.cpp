#include "perimpact/materials/ordinary_state/setup.hpp"

namespace perimpact {

std::span<const Field<OrdinaryStateSetup>> OrdinaryStateSetup::fields() {
  static const auto all = with_elastic_fields<OrdinaryStateSetup>({poissons_ratio_field<OrdinaryStateSetup>()});
  return all;
}

}  // namespace perimpact
