/// VTK legacy files (.vtk), text and binary, versions 2 to 5.1.
#pragma once

#include <string>
#include <string_view>

#include "mesh_io/file/elements.hpp"
#include "mesh_io/vtk/point_values.hpp"

namespace fccda {

/// Reads the cells of a POLYDATA or UNSTRUCTURED_GRID file, in its units (cell types: vtk_cells.hpp); other kinds of DATASET are refused.
/// Cells may be lists with lengths (up to version 4.2) or OFFSETS and CONNECTIVITY (from 5.0). Parts are the values of the integer cell
/// array with the best vtk_part_rank(), named `part 3` and so on. Other point, cell and field data are skipped. Throws InputError with the
/// file and the line (text) or the section (binary).
///
/// Format: VTK File Formats, Simple Legacy Formats, https://docs.vtk.org/en/latest/vtk_file_formats/vtk_legacy_file_format.html
Elements parse_vtk(std::string_view contents, const std::string& file);

/// Reads the points and the scalar point array of that name (one component, SCALARS or in a FIELD).
PointValues parse_vtk_points(std::string_view contents, const std::string& file, std::string_view array);

/// Reads the points with the selected point arrays (VECTORS, TENSORS6, SCALARS or in a FIELD) and field data (a FIELD before POINT_DATA). Bytes written as %20
/// and the like are decoded in names.
PointData parse_vtk_arrays(std::string_view contents, const std::string& file, const ArrayFilter& is_wanted);

}  // namespace fccda
