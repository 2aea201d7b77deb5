/// Some parts of a mesh in place of all.
#pragma once

#include <span>
#include <string>

#include "mesh/panels.hpp"
#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Leaves the panels of the named parts only; all where `parts` is empty. Throws InputError where a name is none of the file's parts: it
/// says what was probably meant, or which there are.
void keep_parts(Panels& panels, std::span<const std::string> parts, const std::string& file);

/// The same of elements: solids of the parts that are left have a skin where they met those that are not.
void keep_parts(Elements& elements, std::span<const std::string> parts, const std::string& file);

}  // namespace fccda
