/// An impactor's region in words, for `check`.
#pragma once

#include <string>

#include "perimpact/impact/impactor.hpp"

namespace perimpact {

std::string region_text(const Impactor& impactor);

}  // namespace perimpact
