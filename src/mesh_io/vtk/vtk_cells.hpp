/// Cells of VTK files, legacy and XML, as elements.
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

/// Of all cells one after the other: the numbers of their points, and where those of each cell end.
struct VtkCells {
  std::vector<std::int64_t> points, ends;

  std::size_t size() const { return ends.size(); }
};

/// Cell types by VTK's numbers (vtkCellType.h) that PolyData has without saying so.
constexpr std::int64_t vtk_poly_vertex = 2, vtk_poly_line = 4, vtk_triangle_strip = 6, vtk_polygon = 7;

/// Which of the cell arrays that number parts this is, 0 the first choice; -1 for any other array. The arrays, in this order: `part`, `PartId`,
/// `gmsh:physical`, `gmsh:geometrical`, `medit:ref`, `CellEntityIds`, `STLSolidLabeling`.
int vtk_part_rank(std::string_view array);

/// Turns the cells of one or several pieces into elements.
///
/// Vertices and lines are passed over, strips become triangles, pixels quads and voxels hexahedra. Quadratic cells with points in faces and
/// within (triangle 7, hexahedron 24 and 27, wedge 18, pyramid 19) are read without those. Cells with other shape functions or faces
/// (Lagrange, Bézier, polyhedra, …) are refused by name.
class VtkElements {
 public:
  /// `file`: how messages begin.
  explicit VtkElements(std::string file) : file_(std::move(file)) {}

  /// The points that the cells added from here on count from 0. Throws InputError where they are more than an int can count.
  void begin_piece(std::span<const double> coordinates);

  /// `types`: one for each cell, or one for all. `parts`: the number of each cell's part, or empty. Throws InputError that names the cell,
  /// counted from 0 as VTK does, where its points are out of range, too many or too few, or where its type is refused.
  void add(const VtkCells& cells, std::span<const std::int64_t> types, std::span<const std::int64_t> parts);

  Elements take() { return std::move(out_); }

 private:
  void add_cell(std::int64_t type, std::span<const int> points);
  [[noreturn]] void fail(const std::string& sentence) const;

  std::string file_;
  Elements out_;
  std::size_t piece_ = 0;  // from 1
  std::size_t first_point_ = 0;
  std::size_t cell_ = 0;  // that is being added, in its piece
  int part_ = 0;          // of the cell
};

}  // namespace fccda
