#include "perimpact/contact_bounds/automatic/setup.hpp"

namespace perimpact {

std::span<const Field<AutoBoundsSetup>> AutoBoundsSetup::fields() { return {}; }

void AutoBoundsSetup::check(const DeckContext&) const {}

}  // namespace perimpact
