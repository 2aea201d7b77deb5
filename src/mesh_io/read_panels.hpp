/// Reading of surfaces and meshes from files of any supported format.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "mesh/panels.hpp"
#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Reads the panels of a file in the format of its extension (followed by `.gz` where compressed), in the file's units and in double precision (CAD files in
/// metres); all parts, or the named ones. Solid elements contribute their boundary faces. Throws InputError with the file and the line, byte or triangle where
/// there is nothing to read or the contents are damaged. Memory use is bounded by a few times the (decompressed) file size, whatever counts the file states.
/// Throws RunError where the CAD mesher cannot be run: no temporary folder, no space in it, or no new process.
Panels read_panels(const std::filesystem::path& path, std::span<const std::string> parts = {});

/// The same for contents in memory; `file` gives the name and format. Not available for CAD files.
Panels parse_panels(std::string_view contents, const std::filesystem::path& file, std::span<const std::string> parts = {});

/// Reads the elements of a mesh file, including solids: all parts, or the named ones. Throws InputError as read_panels does, and for
/// surface-only formats.
Elements read_elements(const std::filesystem::path& path, std::span<const std::string> parts = {});

}  // namespace fccda
