/// Linear elements that repeat nodes: the way in which solvers write triangles as quads, and tetrahedra, pyramids and wedges as hexahedra.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// An element of a kind, by the numbers that its file gives the nodes.
struct NumberedShape {
  ElementKind kind = ElementKind::polygon;
  std::array<std::int64_t, 8> nodes{};
  std::size_t count = 0;
  std::span<const std::int64_t> all() const { return std::span(nodes).first(count); }
};

bool repeats_nodes(std::span<const std::int64_t> nodes);

/// What a triangle or quad is when a node that follows itself is taken once. Nothing where fewer than three are left, or one comes again later.
std::optional<NumberedShape> surface_without_repeats(std::span<const std::int64_t> corners);

/// What a tetrahedron (4 nodes), pyramid (5), wedge (6) or hexahedron (8) is when edges and faces between equal nodes have shrunk to points: one of
/// those four kinds. Nothing where it is none, as a hexahedron of seven nodes, or one folded flat.
std::optional<NumberedShape> solid_without_repeats(std::span<const std::int64_t> corners);

}  // namespace fccda
