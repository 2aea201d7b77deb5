/// Output of surface defects for ParaView.
#pragma once

#include <filesystem>
#include <span>

#include "mesh/defects.hpp"
#include "mesh/panels.hpp"

namespace perimpact {

/// Writes the panels with one of the defects, in the coordinates of `panels`. Cell arrays: `defect`, the number of fccda::DefectKind
/// (docs/guide/surface_meshes.md), and `panel`, the panel number in the file. Throws RunError where the file cannot be written.
void write_defects(const std::filesystem::path& path, const fccda::Panels& panels, std::span<const fccda::Defect> defects);

}  // namespace perimpact
