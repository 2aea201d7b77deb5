/// Surfaces as files that other programs read: STL and OBJ.
#pragma once

#include <filesystem>

#include "mesh/surface.hpp"

namespace perimpact::output {

/// Writes the triangles as they were made fit, wound outward, in metres. By the extension: `.stl`, binary, which rounds coordinates to
/// floats, or as text with 17 digits where parts have names, each a solid; `.obj`, text with 17 digits, vertices shared, parts as groups.
/// Throws InputError for any other extension, RunError where the file cannot be written.
void write_surface(const std::filesystem::path& path, const fccda::Surface& surface);

/// Throws InputError where write_surface would: for another extension, and where there is no place for the file. To be asked before long work.
void expect_surface_file(const std::filesystem::path& path);

}  // namespace perimpact::output
