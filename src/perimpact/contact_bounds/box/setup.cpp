#include "perimpact/contact_bounds/box/setup.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<BoxRegionSetup>> BoxRegionSetup::fields() {
  using S = BoxRegionSetup;
  static const Field<S> all[] = {{"size", &S::size, "m", positive(), required, "Edge lengths along the surface's axes."},
                                 {"centre", &S::centre, "m", any_number(), optional, "Centre, relative to the surface's origin."}};
  return all;
}

void BoxRegionSetup::check(const DeckContext&) const {}

}  // namespace perimpact
