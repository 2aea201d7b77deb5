/// The panels of a surface file, where the Setup wants them.
#pragma once

#include "fccda/surface/panels.hpp"
#include "perimpact/setup/file_surface.hpp"

namespace perimpact {

/// Throws InputError, one sentence that names the file, where it cannot be read.
fccda::Panels panels_of_file(const FileSurface& setup);

}  // namespace perimpact
