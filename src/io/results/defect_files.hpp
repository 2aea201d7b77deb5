/// Pictures of what is wrong with a surface.
#pragma once

#include <filesystem>
#include <span>

#include "mesh/defects.hpp"
#include "mesh/panels.hpp"

namespace perimpact {

/// The panels that have one of the defects, for ParaView, in the coordinates of `panels`. Cell arrays: `defect`, the number of
/// fccda::DefectKind (docs/guide/surface_meshes.md), and `panel`, as the file counts them. Throws RunError where the file cannot be written.
void write_defects(const std::filesystem::path& path, const fccda::Panels& panels, std::span<const fccda::Defect> defects);

}  // namespace perimpact
