/// Effect of coarsening and refinement on an impactor's panels as text, for `check`.
#pragma once

#include <string>

#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

/// Empty without coarsening and refinement.
std::string remesh_text(const Impactor& impactor);

}  // namespace perimpact
