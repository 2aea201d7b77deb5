/// Export of surfaces as STL and OBJ.
#pragma once

#include <filesystem>

#include "mesh/surface.hpp"

namespace perimpact::output {

/// Writes the triangles after repair, oriented outward, in metres. The extension selects the format: `.stl`, binary with coordinates rounded
/// to floats, or text with 17 digits and a solid per part where parts have names; `.obj`, text with 17 digits, shared vertices, parts as
/// groups. Throws InputError for any other extension, RunError where the file cannot be written.
void write_surface(const std::filesystem::path& path, const fccda::Surface& surface);

/// Checks the path before a long computation: throws InputError for another extension, and where the file cannot be created.
void expect_surface_file(const std::filesystem::path& path);

}  // namespace perimpact::output
