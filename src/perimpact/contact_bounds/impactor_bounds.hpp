/// Contact bounds of an impactor, and what of them was fitted.
#pragma once

#include <string>

#include "fccda/contact_bounds/all_contact_bounds.hpp"

namespace perimpact {

struct ImpactorBounds {
  fccda::ContactBounds region;
  std::string fitted;  ///< description of fitted values; empty if the bounds were given
};

}  // namespace perimpact
