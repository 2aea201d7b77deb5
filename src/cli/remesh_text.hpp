/// What coarsening and refinement did to the panels of an impactor, in words, for `check`.
#pragma once

#include <string>

#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

/// Empty where the deck asks for neither.
std::string remesh_text(const Impactor& impactor);

}  // namespace perimpact
