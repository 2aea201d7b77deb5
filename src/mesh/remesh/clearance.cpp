#include "mesh/remesh/clearance.hpp"

#include <algorithm>
#include <cstddef>

#include "base/parallel.hpp"
#include "mesh/search/bvh.hpp"

namespace fccda {
namespace {

class Sheets {
 public:
  Sheets(const Surface& surface, double reach) : bvh_(surface), reach_(reach), tiny_(1e-9 * norm(surface.report().bounds.size())) {}

  /// [m] Distance to the next sheet on either side of a point of the surface; the reach if there is none.
  double gap(const Vec3d& point, const Vec3d& normal) const {
    std::size_t tested = 0;
    double nearest = reach_;
    const Vec3d above = point + tiny_ * normal, below = point - tiny_ * normal;
    if (const auto hit = bvh_.first_hit(above, above + reach_ * normal, tested)) nearest = hit->fraction * reach_;
    // A sheet on the inward side shows its back. So the ray is cast from its other end, where the last crossing from the front is the nearest.
    for (double start = nearest; start > tiny_;) {
      const auto hit = bvh_.first_hit(below - start * normal, below, tested);
      if (!hit) break;
      nearest = (1 - hit->fraction) * start;
      start = nearest - tiny_;
    }
    return nearest;
  }

 private:
  Bvh bvh_;
  double reach_, tiny_;  // [m]
};

}  // namespace

std::vector<double> clearance(const Surface& surface, double most) {
  const Sheets sheets(surface, 3 * most);
  std::vector<std::array<double, 4>> gaps(surface.triangles().size());
  parallel_for(static_cast<std::ptrdiff_t>(gaps.size()), [&](std::ptrdiff_t i) {
    const auto t = static_cast<std::size_t>(i);
    const Vec3d middle = (surface.corner(t, 0) + surface.corner(t, 1) + surface.corner(t, 2)) / 3.0;
    gaps[t][3] = sheets.gap(middle, surface.normal(t));
    for (std::size_t c = 0; c < 3; ++c) {
      // slightly inside the triangle, where its own normal applies
      const Vec3d corner = surface.corner(t, c) + 0.1 * (middle - surface.corner(t, c));
      gaps[t][c] = sheets.gap(corner, surface.normal(t));
    }
  });
  std::vector<double> out;
  out.reserve(gaps.size());
  for (const auto& gap : gaps) out.push_back(*std::min_element(gap.begin(), gap.end()) / 3);
  return out;
}

}  // namespace fccda
