/// Conversion of VTK cells, legacy and XML, to elements.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Cell connectivity: point numbers of all cells, and the end of each cell's range.
struct VtkCells {
  std::vector<std::int64_t> points, ends;

  std::size_t size() const { return ends.size(); }
};

/// The implicit cell types of PolyData, by VTK number (vtkCellType.h).
constexpr std::int64_t vtk_poly_vertex = 2, vtk_poly_line = 4, vtk_triangle_strip = 6, vtk_polygon = 7;

/// Rank of a cell array as the source of part numbers, 0 the first choice; -1 for any other array. In order of rank: `part`, `PartId`,
/// `gmsh:physical`, `gmsh:geometrical`, `medit:ref`, `CellEntityIds`, `STLSolidLabeling`.
int vtk_part_rank(std::string_view array);

/// Converts the cells of one or several pieces to elements.
///
/// Vertices and lines are skipped, strips become triangles, pixels quads and voxels hexahedra. Mid-face and interior points of quadratic
/// cells (triangle 7, hexahedron 24 and 27, wedge 18, pyramid 19) are dropped. Cells with other shape functions or faces (Lagrange, Bézier,
/// polyhedra, …) are refused by name.
class VtkElements {
 public:
  /// `file`: prefix of messages.
  explicit VtkElements(std::string file) : file_(std::move(file)) {}

  /// Starts a piece: cells added from now on number these points from 0. Throws InputError where the points exceed the range of int.
  void begin_piece(std::span<const double> coordinates);

  /// `types`: one per cell, or one for all. `parts`: part number per cell, or empty. Throws InputError with the cell, counted from 0 as in
  /// VTK, where its points are out of range, too many or too few, or its type is not supported.
  void add(const VtkCells& cells, std::span<const std::int64_t> types, std::span<const std::int64_t> parts);

  Elements take() { return std::move(out_); }

 private:
  void add_cell(std::int64_t type, std::span<const int> points);
  [[noreturn]] void fail(const std::string& sentence) const;

  std::string file_;
  Elements out_;
  std::size_t piece_ = 0;  // from 1
  std::size_t first_point_ = 0;
  std::size_t cell_ = 0;  // current cell in its piece
  int part_ = 0;          // part of the current cell
};

}  // namespace fccda
