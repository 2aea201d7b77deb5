/// Contact bounds of an impactor as text, for `check`.
#pragma once

#include <string>

#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

std::string contact_bounds_text(const Impactor& impactor);

}  // namespace perimpact
