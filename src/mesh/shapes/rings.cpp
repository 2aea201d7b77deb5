#include "mesh/shapes/rings.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "mesh/shapes/divisions.hpp"

namespace fccda {
namespace {

/// The angle 2πk/n.
Vec3d on_unit_circle(int k, int n) {
  const int quarter = n / 4, turns = k / quarter, rest = k % quarter;
  const bool beyond_eighth = 2 * rest > quarter;
  const double angle = 2 * std::numbers::pi * (beyond_eighth ? quarter - rest : rest) / n;
  double x = std::cos(angle), y = std::sin(angle);
  if (2 * rest == quarter) y = x;
  if (beyond_eighth) std::swap(x, y);
  switch (turns) {
    case 0:
      return {x, y, 0};
    case 1:
      return {-y, x, 0};
    case 2:
      return {-x, -y, 0};
    default:
      return {y, -x, 0};
  }
}

}  // namespace

Ring add_ring(Panels& out, int count, double radius, double z) {
  const Ring ring{static_cast<int>(out.vertices.size()), count};
  for (int k = 0; k < count; ++k) {
    const Vec3d unit = on_unit_circle(k, count);
    out.vertices.push_back({radius * unit.x, radius * unit.y, z});
  }
  return ring;
}

void zip_rings(Panels& out, const Ring& inner, const Ring& outer, Facing facing) {
  const auto add = [&](int a, int b, int c) { facing == Facing::up ? out.add_triangle(a, b, c) : out.add_triangle(a, c, b); };
  for (int i = 0, o = 0; i < inner.count || o < outer.count;) {
    // (o + 1/2)/outer.count <= (i + 1/2)/inner.count in integers; a completed ring comes last
    const bool outer_is_next = static_cast<long long>(2 * o + 1) * inner.count <= static_cast<long long>(2 * i + 1) * outer.count;
    if (outer_is_next) {
      add(inner.vertex(i), outer.vertex(o), outer.vertex(o + 1));
      ++o;
    } else {
      add(inner.vertex(i), outer.vertex(o), inner.vertex(i + 1));
      ++i;
    }
  }
}

void add_cap(Panels& out, const Ring& rim, double radius, double z, double panel, Facing facing) {
  const int rings = static_cast<int>(divisions(radius, panel));
  Ring outer = rim;
  for (int r = rings - 1; r > 0; --r) {
    const double inner_radius = radius * r / rings;
    const Ring inner = add_ring(out, static_cast<int>(circle_divisions(inner_radius, panel)), inner_radius, z);
    zip_rings(out, inner, outer, facing);
    outer = inner;
  }
  const int middle = static_cast<int>(out.vertices.size());
  out.vertices.push_back({0, 0, z});
  for (int k = 0; k < outer.count; ++k) {
    const int a = outer.vertex(k), b = outer.vertex(k + 1);
    facing == Facing::up ? out.add_triangle(middle, a, b) : out.add_triangle(middle, b, a);
  }
}

}  // namespace fccda
