/// Stresses of an elastic body by superposition of its modes.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "fccda/elastic/elastic_body.hpp"

namespace fccda {

/// Equivalent stress of von Mises, √(3 J₂), in the unit of the tensor.
inline double von_mises(const SymmetricTensor& stress) {
  const auto& [xx, yy, zz, xy, yz, zx] = stress;
  const double normal = (xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx);
  return std::sqrt(0.5 * normal + 3 * (xy * xy + yz * yz + zx * zx));
}

/// Whether every mode has stresses; without those of some, the sum is not the stress.
inline bool have_stresses(std::span<const Mode> modes) {
  return !modes.empty() && std::ranges::all_of(modes, [](const Mode& mode) { return !mode.stress.empty(); });
}

/// [Pa] of any vertex.
inline double largest_von_mises(const ElasticBody& body) {
  double largest = 0;
  for (std::size_t v = 0; v < body.vertex_count(); ++v) largest = std::max(largest, von_mises(body.stress(v)));
  return largest;
}

}  // namespace fccda
