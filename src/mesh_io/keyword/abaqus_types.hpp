/// Abaqus element types.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mesh_io/file/elements.hpp"

namespace fccda {

struct AbaqusType {
  enum class Use : std::uint8_t {
    surface,  ///< shells, membranes, surface and rigid elements
    solid,    ///< solids, continuum shells and cohesive elements: their boundary faces are used
    skipped,  ///< lines, points, springs: no surface
    plane,    ///< plane and axisymmetric elements: no 3-D geometry
    unknown
  };
  Use use = Use::unknown;
  ElementKind kind = ElementKind::polygon;
  std::size_t nodes = 0;
};

/// Classifies a type name (in capitals: C3D8R, S4R5, STRI65). Letters after the number of nodes, such as R, I, H, T, M, select the element
/// formulation and do not affect the geometry (Abaqus Analysis User's Guide, "Element index").
AbaqusType abaqus_type(std::string_view name);

}  // namespace fccda
