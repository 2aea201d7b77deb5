/// Gmsh element types, and the mapping of their nodes to those of Elements.
#pragma once

#include <cstdint>
#include <span>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// A Gmsh element type. Gmsh orders corners as Elements does, but mid-side nodes of solids differently (Gmsh reference manual, section "Node
/// ordering"). Mid-face and mid-volume nodes are not used.
struct GmshKind {
  int type;                                ///< Gmsh's type number
  int dimension;                           ///< 0 point, 1 line, 2 surface, 3 solid
  int nodes;                               ///< in the file
  ElementKind kind;                        ///< surfaces and solids only
  std::span<const std::uint8_t> order;     ///< indices of the file's nodes in the order of Elements; surfaces and solids only
  std::span<const std::uint8_t> reversed;  ///< the same for a reversed element; surfaces only
};

/// Points, lines, surfaces and solids of first and second order; nullptr for other types.
const GmshKind* gmsh_kind(int type);

}  // namespace fccda
