/// VTK XML files of surfaces and unstructured meshes (.vtp, .vtu).
#pragma once

#include <string>
#include <string_view>

#include "mesh_io/file/elements.hpp"
#include "mesh_io/vtk/point_values.hpp"

namespace fccda {

/// Reads the cells of a PolyData or UnstructuredGrid file, in its units (cell types: vtk_cells.hpp); all pieces concatenated, each with its
/// own points. Arrays may be ascii, inline base64 or appended (raw or base64), with 32- or 64-bit counts, in either byte order, plain or
/// compressed by vtkZLibDataCompressor; other compressors and data sets are refused. Parts are the values of the integer cell array with the
/// best vtk_part_rank(), named `part 3` and so on. Other arrays are skipped without decoding. Throws InputError with the file, the line and
/// the array.
///
/// Format: VTK File Formats, XML File Formats, https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html
Elements parse_vtp(std::string_view contents, const std::string& file);

/// Reads the points and the scalar array of PointData of that name (one component).
PointValues parse_vtp_points(std::string_view contents, const std::string& file, std::string_view array);

/// Reads the points with the selected arrays of PointData and FieldData. All pieces must have the same arrays.
PointData parse_vtp_arrays(std::string_view contents, const std::string& file, const ArrayFilter& is_wanted);

}  // namespace fccda
