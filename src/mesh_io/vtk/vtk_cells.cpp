#include "mesh_io/vtk/vtk_cells.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/contract.hpp"
#include "base/error.hpp"

namespace fccda {
namespace {

constexpr std::string_view part_arrays[] = {"part", "PartId", "gmsh:physical", "gmsh:geometrical", "medit:ref", "CellEntityIds", "STLSolidLabeling"};

/// Cells without area: empty, vertex, vertices, line, lines; quadratic, cubic, Lagrange and Bézier curves.
constexpr std::int64_t without_area[] = {0, 1, 2, 3, 4, 21, 35, 68, 75};

/// Supported cells by VTK type number, with their number of points; points within faces and cells come last and are dropped.
struct Known {
  std::int64_t type;
  ElementKind kind;
  std::size_t points;
};
constexpr Known known_cells[] = {{5, ElementKind::polygon, 3},         {9, ElementKind::polygon, 4},         {10, ElementKind::tetrahedron, 4},
                                 {12, ElementKind::hexahedron, 8},     {13, ElementKind::wedge, 6},          {14, ElementKind::pyramid, 5},
                                 {22, ElementKind::triangle_6, 6},     {23, ElementKind::quad_8, 8},         {24, ElementKind::tetrahedron_10, 10},
                                 {25, ElementKind::hexahedron_20, 20}, {26, ElementKind::wedge_15, 15},      {27, ElementKind::pyramid_13, 13},
                                 {28, ElementKind::quad_9, 9},         {29, ElementKind::hexahedron_20, 27}, {32, ElementKind::wedge_15, 18},
                                 {33, ElementKind::hexahedron_20, 24}, {34, ElementKind::triangle_6, 7},     {37, ElementKind::pyramid_13, 19}};

constexpr std::pair<std::int64_t, std::string_view> refused_cells[] = {
    {15, "pentagonal prism"},    {16, "hexagonal prism"},   {30, "quadratic-linear quad"}, {31, "quadratic-linear wedge"}, {36, "quadratic polygon"},
    {41, "convex point set"},    {42, "polyhedron"},        {69, "Lagrange triangle"},     {70, "Lagrange quadrilateral"}, {71, "Lagrange tetrahedron"},
    {72, "Lagrange hexahedron"}, {73, "Lagrange wedge"},    {74, "Lagrange pyramid"},      {76, "Bézier triangle"},        {77, "Bézier quadrilateral"},
    {78, "Bézier tetrahedron"},  {79, "Bézier hexahedron"}, {80, "Bézier wedge"},          {81, "Bézier pyramid"}};

constexpr std::int64_t pixel = 8, voxel = 11;

bool has_area(std::int64_t type) { return std::find(std::begin(without_area), std::end(without_area), type) == std::end(without_area); }

const Known* known_cell(std::int64_t type) {
  const auto found = std::find_if(std::begin(known_cells), std::end(known_cells), [&](const Known& cell) { return cell.type == type; });
  return found == std::end(known_cells) ? nullptr : found;
}

bool is_readable(std::int64_t type) {
  return !has_area(type) || known_cell(type) || type == vtk_polygon || type == vtk_triangle_strip || type == pixel || type == voxel;
}

std::string name_of(std::int64_t type) {
  const auto found = std::find_if(std::begin(refused_cells), std::end(refused_cells), [&](const auto& cell) { return cell.first == type; });
  return found == std::end(refused_cells) ? "a cell of VTK's type " + std::to_string(type) : "a " + std::string(found->second);
}

}  // namespace

int vtk_part_rank(std::string_view array) {
  const auto found = std::find(std::begin(part_arrays), std::end(part_arrays), array);
  return found == std::end(part_arrays) ? -1 : static_cast<int>(found - std::begin(part_arrays));
}

void VtkElements::fail(const std::string& sentence) const {
  const std::string piece = piece_ > 1 ? "piece " + std::to_string(piece_) + ": " : "";
  throw InputError(file_ + ": " + piece + "cell " + std::to_string(cell_) + " (counted from 0) " + sentence);
}

void VtkElements::begin_piece(std::span<const double> coordinates) {
  EXPECTS(coordinates.size() % 3 == 0);
  ++piece_;
  first_point_ = out_.vertices.size();
  cell_ = 0;
  if (coordinates.size() / 3 > static_cast<std::size_t>(std::numeric_limits<int>::max()) - first_point_)
    throw InputError(file_ + ": too many points; coarsen the mesh.");
  for (std::size_t k = 0; k < coordinates.size(); k += 3) out_.vertices.push_back({coordinates[k], coordinates[k + 1], coordinates[k + 2]});
}

void VtkElements::add(const VtkCells& cells, std::span<const std::int64_t> types, std::span<const std::int64_t> parts) {
  EXPECTS(types.size() == 1 || types.size() == cells.size());
  EXPECTS(parts.empty() || parts.size() == cells.size());
  const std::size_t count = out_.vertices.size() - first_point_;
  std::vector<int> points;
  std::size_t begin = 0;
  for (std::size_t c = 0; c < cells.size(); ++c, ++cell_) {
    const std::int64_t type = types.size() == 1 ? types.front() : types[c];
    if (!is_readable(type))
      fail("is " + name_of(type) + ", which is not supported; export linear or quadratic cells, for example with the ParaView filter Extract Surface.");
    const auto end = static_cast<std::size_t>(cells.ends[c]);
    if (cells.ends[c] < 0 || end < begin || end > cells.points.size()) fail("has an offset that is out of order; correct the file or export it again.");
    points.clear();
    for (; begin < end; ++begin) {
      const std::int64_t point = cells.points[begin];
      if (point < 0 || static_cast<std::uint64_t>(point) >= count)
        fail("has point " + std::to_string(point) + ", but there are " + std::to_string(count) + ", counted from 0; correct the file or export it again.");
      points.push_back(static_cast<int>(first_point_ + static_cast<std::size_t>(point)));
    }
    if (c == 0 || (!parts.empty() && parts[c] != parts[c - 1]))  // one look-up per run of cells of equal part
      part_ = out_.part_number(parts.empty() ? "" : "part " + std::to_string(parts[c]));
    add_cell(type, points);
  }
  if (begin != cells.points.size()) {
    throw InputError(file_ + ": the cells have " + std::to_string(begin) + " point numbers, but the file has " + std::to_string(cells.points.size()) +
                     "; correct the file or export it again.");
  }
}

void VtkElements::add_cell(std::int64_t type, std::span<const int> points) {
  const auto expect = [&](bool is_right, std::size_t expected) {
    if (!is_right) fail("has " + std::to_string(points.size()) + " points, but needs " + std::to_string(expected) + "; correct the file or export it again.");
  };
  const auto add = [&](ElementKind kind, std::span<const int> nodes) { out_.add(kind, nodes, part_); };
  if (!has_area(type)) return;
  if (type == vtk_polygon) {
    expect(points.size() >= 3, 3);
    return add(ElementKind::polygon, points);
  }
  if (type == vtk_triangle_strip) {
    expect(points.size() >= 3, 3);
    for (std::size_t k = 0; k + 2 < points.size(); ++k) {  // every second triangle of a strip has opposite orientation
      const std::size_t odd = k % 2;
      add(ElementKind::polygon, std::array{points[k + odd], points[k + 1 - odd], points[k + 2]});
    }
    return;
  }
  if (type == pixel) {
    expect(points.size() == 4, 4);
    return add(ElementKind::polygon, std::array{points[0], points[1], points[3], points[2]});
  }
  if (type == voxel) {
    expect(points.size() == 8, 8);
    return add(ElementKind::hexahedron, std::array{points[0], points[1], points[3], points[2], points[4], points[5], points[7], points[6]});
  }
  const Known* known = known_cell(type);
  expect(points.size() == known->points, known->points);
  add(known->kind, known->kind == ElementKind::polygon ? points : points.first(nodes_of(known->kind)));
}

}  // namespace fccda
