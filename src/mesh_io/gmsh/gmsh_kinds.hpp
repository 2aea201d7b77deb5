/// The types of elements that Gmsh numbers, and how their nodes become those of Elements.
#pragma once

#include <cstdint>
#include <span>

#include "mesh_io/file/elements.hpp"

namespace fccda {

/// Gmsh orders corners as Elements does. Its nodes in the middle of edges come in another order in solids (reference manual of Gmsh,
/// section "Node ordering"). Those in the middle of a solid's faces, and of the solid, are not used.
struct GmshKind {
  int type;                                ///< Gmsh's number
  int dimension;                           ///< 0 point, 1 line, 2 surface, 3 solid
  int nodes;                               ///< in the file
  ElementKind kind;                        ///< of surfaces and solids
  std::span<const std::uint8_t> order;     ///< which of the file's nodes are the element's, in its order; of surfaces and solids
  std::span<const std::uint8_t> reversed;  ///< the same for an element turned over; of surfaces
};

/// Points, lines, surfaces and solids of first and second order; nullptr for other types.
const GmshKind* gmsh_kind(int type);

}  // namespace fccda
