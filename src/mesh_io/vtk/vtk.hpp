/// VTK's legacy files (.vtk), text and binary, versions 2 to 5.1.
#pragma once

#include <string>
#include <string_view>

#include "mesh_io/file/elements.hpp"
#include "mesh_io/vtk/point_values.hpp"

namespace fccda {

/// The cells of a POLYDATA or UNSTRUCTURED_GRID file's contents, in its units, as vtk_cells.hpp says; other kinds of DATASET are refused.
/// Cells may be lists with their lengths (up to version 4.2) or OFFSETS and CONNECTIVITY (5.0 on). Parts are the numbers of the first integer
/// cell array that vtk_part_rank() knows, named `part 3` and so on. Other data of points, cells and the file are passed over. Throws
/// InputError that names the file and the line (text) or the section (binary).
///
/// Format: VTK File Formats, Simple Legacy Formats, https://docs.vtk.org/en/latest/vtk_file_formats/vtk_legacy_file_format.html
Elements parse_vtk(std::string_view contents, const std::string& file);

/// Its points, and of the array of point data of that name (of one component, SCALARS or in a FIELD) a number for each.
PointValues parse_vtk_points(std::string_view contents, const std::string& file, std::string_view array);

}  // namespace fccda
