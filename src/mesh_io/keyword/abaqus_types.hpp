/// The element types of Abaqus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesh_io/file/elements.hpp"

namespace fccda {

struct AbaqusType {
  enum class Use : std::uint8_t {
    surface,  ///< shells, membranes, surface and rigid elements
    solid,    ///< with a skin; continuum shells and cohesive layers too
    skipped,  ///< lines, points, springs: without a surface
    plane,    ///< plane and axisymmetric elements: they have no place in space
    unknown
  };
  Use use = Use::unknown;
  ElementKind kind = ElementKind::polygon;
  std::size_t nodes = 0;
};

/// What a type (in capitals: C3D8R, S4R5, STRI65) is. Letters behind the number of nodes, such as R, I, H, T, M, choose how the solver integrates: the
/// shape is the same. (Abaqus Analysis User's Guide, "Element index".)
AbaqusType abaqus_type(std::string_view name);

}  // namespace fccda
