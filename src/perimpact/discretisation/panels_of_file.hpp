/// Panels of a surface file, scaled and placed as in the Setup.
#pragma once

#include "mesh/panels.hpp"
#include "perimpact/deck_model/file_surface.hpp"

namespace perimpact {

/// Throws InputError with the file name if it cannot be read.
fccda::Panels panels_of_file(const FileSurface& setup);

}  // namespace perimpact
