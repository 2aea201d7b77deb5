/// The panels of a surface file, where the Setup wants them.
#pragma once

#include "mesh/panels.hpp"
#include "perimpact/deck_model/file_surface.hpp"

namespace perimpact {

/// Throws InputError, one sentence that names the file, where it cannot be read.
fccda::Panels panels_of_file(const FileSurface& setup);

}  // namespace perimpact
