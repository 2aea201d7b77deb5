/// VTK's XML files of surfaces and meshes without structure (.vtp, .vtu).
#pragma once

#include <string>
#include <string_view>

#include "mesh_io/file/elements.hpp"
#include "mesh_io/vtk/point_values.hpp"

namespace fccda {

/// The cells of a PolyData or UnstructuredGrid file's contents, in its units, as vtk_cells.hpp says; all pieces one after the other, each
/// with points of its own. Arrays may be text, base64 in place, or appended (raw or base64), with counts of 32 or 64 bits, in either byte
/// order, plain or packed by vtkZLibDataCompressor; other compressors and kinds of data set are refused. Parts are the numbers of the first
/// integer cell array that vtk_part_rank() knows, named `part 3` and so on. Other arrays are passed over, and not decoded. Throws InputError that
/// names the file, the line and the array.
///
/// Format: VTK File Formats, XML File Formats, https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html
Elements parse_vtp(std::string_view contents, const std::string& file);

/// Its points, and of the array of PointData of that name (of one component) a number for each.
PointValues parse_vtp_points(std::string_view contents, const std::string& file, std::string_view array);

}  // namespace fccda
