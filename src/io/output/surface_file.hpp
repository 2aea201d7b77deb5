/// Surfaces as files that other programs read: STL and OBJ.
#pragma once

#include <filesystem>

#include "fccda/surface/surface.hpp"

namespace perimpact::output {

/// Writes the triangles as they were made fit, wound outward, in metres. By the extension: `.stl`, binary, which rounds coordinates to
/// floats, or as text with 17 digits where parts have names, each a solid; `.obj`, text with 17 digits, vertices shared, parts as groups.
/// Throws InputError for any other extension, RunError where the file cannot be written.
void write_surface(const std::filesystem::path& path, const fccda::Surface& surface);

}  // namespace perimpact::output
