/// Which way normals point: out of the material.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/triangle.hpp"
#include "mesh/winding.hpp"

namespace fccda {

/// How an open surface says which side is outside.
enum class Orientation : std::uint8_t { undeclared, normals, reversed };

struct Outward {
  std::size_t flipped = 0;                ///< closed components turned over as a whole
  std::size_t cavities = 0;               ///< closed components that bound a hollow in another
  std::vector<int> solid_of_component{};  ///< the component that bounds the material from outside: its own number, or a cavity's container
};

/// Turns closed components so that their normals point outward by the sign of their volume; one that lies inside an odd number of others
/// bounds a hollow, and its normals point into that. Open components are turned over where `outside` is `reversed`. Throws InputError
/// where a closed component encloses no volume, or one is open and its outside undeclared.
Outward orient_outward(LinkedTriangles& surface, const Components& components, Orientation outside, const std::string& name);

}  // namespace fccda
