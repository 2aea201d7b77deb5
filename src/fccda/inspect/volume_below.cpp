#include "fccda/inspect/volume_below.hpp"

#include <array>
#include <cmath>

#include "fccda/core/contract.hpp"

namespace fccda {

double volume_below(const Surface& surface, double height) {
  EXPECTS(surface.is_closed());
  // ∫ (z - height) n_z dA over what lies below: the lid at z = height adds nothing
  double volume = 0;
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    std::array<Vec3d, 4> below{};  // a triangle without a corner has four at most
    std::size_t count = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3d &a = surface.corner(t, c), &b = surface.corner(t, (c + 1) % 3);
      if (a.z <= height) below[count++] = a;
      if ((a.z < height && b.z > height) || (a.z > height && b.z < height)) below[count++] = a + (height - a.z) / (b.z - a.z) * (b - a);
    }
    for (std::size_t c = 2; c < count; ++c) {
      const Vec3d u = below[c - 1] - below[0], v = below[c] - below[0];
      const double projected = 0.5 * (u.x * v.y - u.y * v.x);
      volume += projected * ((below[0].z + below[c - 1].z + below[c].z) / 3 - height);
    }
  }
  return volume;
}

}  // namespace fccda
