/// Selection of mesh parts by name.
#pragma once

#include <span>
#include <string>

#include "mesh/panels.hpp"
#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Keeps only the panels of the named parts; all where `parts` is empty. Throws InputError for an unknown name, with the closest match or
/// the list of parts.
void keep_parts(Panels& panels, std::span<const std::string> parts, const std::string& file);

/// The same for elements. Faces between kept and removed solids become boundary faces.
void keep_parts(Elements& elements, std::span<const std::string> parts, const std::string& file);

}  // namespace fccda
