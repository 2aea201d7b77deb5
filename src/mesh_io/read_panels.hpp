/// Surfaces from files, whatever their format.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "mesh/panels.hpp"
#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Panels in memory of that name (panels_in_memory.hpp), or of a file in the format that its extension names (with `.gz` behind it where packed), in the file's
/// units and in double precision (CAD files in metres); all parts, or those named. Of solid elements the skin. Throws InputError, one sentence with the file
/// and the line, byte or triangle, where there is nothing to read or the contents are damaged. Needs memory of a few times the file's (unpacked)
/// size, whatever the file says of itself. Throws RunError where the program that meshes CAD files cannot be run: no temporary folder, or no
/// room in it, or no new process.
Panels read_panels(const std::filesystem::path& path, std::span<const std::string> parts = {});

/// The same of contents that are in memory already, as of a file of that name. CAD files have to be files.
Panels parse_panels(std::string_view contents, const std::filesystem::path& file, std::span<const std::string> parts = {});

/// The elements of a mesh file, solid ones too, where its format has them: all parts, or those named. Throws InputError as read_panels does, and
/// for formats that have surfaces only.
Elements read_elements(const std::filesystem::path& path, std::span<const std::string> parts = {});

}  // namespace fccda
