/// Degenerate linear elements: solvers write triangles as quads, and tetrahedra, pyramids and wedges as hexahedra with repeated nodes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Kind of an element and its node numbers in the file.
struct NumberedShape {
  ElementKind kind = ElementKind::polygon;
  std::array<std::int64_t, 8> nodes{};
  std::size_t count = 0;
  std::span<const std::int64_t> all() const { return std::span(nodes).first(count); }
};

bool repeats_nodes(std::span<const std::int64_t> nodes);

/// Reduces a triangle or quad with consecutive equal nodes. Nothing where fewer than three nodes remain or a node recurs later.
std::optional<NumberedShape> surface_without_repeats(std::span<const std::int64_t> corners);

/// Reduces a tetrahedron (4 nodes), pyramid (5), wedge (6) or hexahedron (8) whose edges and faces between equal nodes collapse to points, to one of
/// these four kinds. Nothing where the result is none of them, as for a hexahedron with seven distinct nodes or a flat one.
std::optional<NumberedShape> solid_without_repeats(std::span<const std::int64_t> corners);

}  // namespace fccda
