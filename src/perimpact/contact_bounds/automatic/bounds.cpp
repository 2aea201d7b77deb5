#include "perimpact/contact_bounds/automatic/bounds.hpp"

#include <utility>

#include "fccda/contact_bounds/fit_contact_bounds.hpp"

namespace perimpact {

using namespace fccda;

ImpactorBounds make_bounds(const AutoBoundsSetup&, const Surface& surface, Beyond) {
  FittedBounds fitted = fit_contact_bounds(surface);
  return {std::move(fitted.region), std::move(fitted.choice)};
}

}  // namespace perimpact
