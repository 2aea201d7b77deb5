/// Orientation of normals: out of the material.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/triangle.hpp"
#include "mesh/winding.hpp"

namespace fccda {

/// The declared outside of an open surface: where the normals of its panels point, or the other side. A closed one has its outside outside; there
/// `normals` is without effect, and `reversed` is refused.
enum class Orientation : std::uint8_t { undeclared, normals, reversed };

/// What orient_outward() found and changed.
struct Outward {
  std::size_t flipped = 0;                ///< closed components flipped as a whole
  std::size_t cavities = 0;               ///< closed components that bound a cavity in another
  std::vector<int> solid_of_component{};  ///< the component that bounds the material from outside: its own number, or a cavity's container
};

/// Orients closed components outward by the sign of their volume. One inside an odd number of others bounds a cavity, and its normals
/// point into it. Open components are flipped if `outside` is `reversed`. Throws InputError if a closed component encloses no volume, if
/// one is open and `outside` is undeclared, or if all are closed and `outside` is `reversed`.
Outward orient_outward(LinkedTriangles& surface, const Components& components, Orientation outside, const std::string& name);

}  // namespace fccda
