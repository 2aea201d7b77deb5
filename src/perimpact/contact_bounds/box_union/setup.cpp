#include "perimpact/contact_bounds/box_union/setup.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<BoundsBoxSetup>> BoundsBoxSetup::fields() {
  using S = BoundsBoxSetup;
  static const Field<S> all[] = {{"size", &S::size, "m", positive(), required, "Edge lengths along the surface's axes."},
                                 {"centre", &S::centre, "m", any_number(), optional, "Centre, relative to the surface's origin."}};
  return all;
}

std::span<const Field<BoxUnionBoundsSetup>> BoxUnionBoundsSetup::fields() {
  using S = BoxUnionBoundsSetup;
  static const Field<S> all[] = {
      {"count", &S::count, "1", between(1, 1000), optional, "Maximum number of boxes fitted to the surface. Where absent, 32."},
      {"gain", &S::gain, "1", between(0, 1), optional,
       "Boxes are fitted to the surface as long as a further one saves at least this share of the bounding box. Where absent, 0.003."}};
  return all;
}

void BoxUnionBoundsSetup::check(const DeckContext& deck) const {
  for (const std::string key : {"count", "gain"})
    if (!boxes.empty() && deck.is_given(key)) deck.refuse(key, key + " is given together with boxes, but applies to fitted boxes only; remove one of the two.");
}

}  // namespace perimpact
