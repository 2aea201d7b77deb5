/// Surfaces from files, whatever their format.
#pragma once

#include <filesystem>

#include "fccda/surface/panels.hpp"

namespace fccda {

/// Panels of an STL or OBJ file, chosen by its extension, in the file's units and in double precision. Throws InputError, one sentence with
/// the file and the line or triangle, where there is nothing to read or the contents are damaged. Needs memory of a few times the file's
/// size, whatever the file says of itself.
Panels read_panels(const std::filesystem::path& path);

}  // namespace fccda
