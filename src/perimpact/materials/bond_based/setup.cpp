#include "perimpact/materials/bond_based/setup.hpp"

namespace perimpact {

std::span<const Field<BondBasedSetup>> BondBasedSetup::fields() {
  static const auto all = with_elastic_fields<BondBasedSetup>();
  return all;
}

}  // namespace perimpact
