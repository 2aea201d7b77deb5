/// Summary of a surface as text, for `check` and `mesh`.
#pragma once

#include <string>

#include "mesh/surface.hpp"

namespace perimpact {

std::string surface_text(const fccda::SurfaceReport& report);

}  // namespace perimpact
