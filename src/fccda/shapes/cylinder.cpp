#include "fccda/shapes/cylinder.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "fccda/core/contract.hpp"
#include "fccda/surface/part_naming.hpp"

namespace fccda {
namespace {

/// Equally spaced vertices about the axis z, counted from +x.
struct Ring {
  int first;
  int count;
  int vertex(int k) const { return first + k % count; }
};

/// The angle 2πk/n by symmetry from the first eighth of the circle, so that mirror images agree to the last bit.
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

Ring add_ring(Panels& out, int count, double radius, double z) {
  const Ring ring{static_cast<int>(out.vertices.size()), count};
  for (int k = 0; k < count; ++k) {
    const Vec3d unit = on_unit_circle(k, count);
    out.vertices.push_back({radius * unit.x, radius * unit.y, z});
  }
  return ring;
}

/// Triangles with normals along +z (or -z) between two rings of different counts: the next side is taken from the ring whose next side
/// has its middle at the smaller angle, so that edges between the rings stay within half a side of each.
void zip(Panels& out, const Ring& inner, const Ring& outer, bool upward) {
  const auto add = [&](int a, int b, int c) { upward ? out.add_triangle(a, b, c) : out.add_triangle(a, c, b); };
  for (int i = 0, o = 0; i < inner.count || o < outer.count;) {
    // (o + 1/2)/outer.count <= (i + 1/2)/inner.count in whole numbers; a ring that is used up comes last
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

void add_cap(Panels& out, const Ring& rim, double radius, double z, double panel, bool upward) {
  const int rings = static_cast<int>(divisions(radius, panel));
  Ring outer = rim;
  for (int r = rings - 1; r > 0; --r) {
    const double inner_radius = radius * r / rings;
    const Ring inner = add_ring(out, static_cast<int>(circle_divisions(inner_radius, panel)), inner_radius, z);
    zip(out, inner, outer, upward);
    outer = inner;
  }
  const int middle = static_cast<int>(out.vertices.size());
  out.vertices.push_back({0, 0, z});
  for (int k = 0; k < outer.count; ++k) {
    upward ? out.add_triangle(middle, outer.vertex(k), outer.vertex(k + 1)) : out.add_triangle(middle, outer.vertex(k + 1), outer.vertex(k));
  }
}

}  // namespace

Panels make_cylinder(const CylinderShape& shape) {
  EXPECTS(shape.diameter > 0 && shape.height > 0 && shape.panel > 0);
  const double radius = 0.5 * shape.diameter;
  const double columns = circle_divisions(radius, shape.panel), rows = divisions(shape.height, shape.panel);
  // rings of the caps have about as many vertices as their circumference has panels
  expect_affordable(2 * columns * (rows + divisions(radius, shape.panel)), shape.panel, "cylinder");

  Panels out;
  PartNaming parts(out);
  parts.begin("bottom");
  Ring below = add_ring(out, static_cast<int>(columns), radius, -0.5 * shape.height);
  add_cap(out, below, radius, -0.5 * shape.height, shape.panel, false);
  parts.begin("side");
  const int row_count = static_cast<int>(rows);
  for (int row = 1; row <= row_count; ++row) {
    // from the middle, so that rows are mirror images too
    const Ring above = add_ring(out, below.count, radius, 0.5 * shape.height * (static_cast<double>(2 * row - row_count) / row_count));
    for (int k = 0; k < below.count; ++k) {
      const int a = below.vertex(k), b = below.vertex(k + 1), c = above.vertex(k + 1), d = above.vertex(k);
      if (shape.panels == PanelKind::quads) {
        out.add_quad(a, b, c, d);
      } else {
        out.add_triangle(a, b, c);
        out.add_triangle(a, c, d);
      }
    }
    below = above;
  }
  parts.begin("top");
  add_cap(out, below, radius, 0.5 * shape.height, shape.panel, true);
  parts.finish();

  // cyclic exchange of the axes keeps the winding
  for (Vec3d& v : out.vertices) {
    if (shape.axis == Axis::x) v = {v.z, v.x, v.y};
    if (shape.axis == Axis::y) v = {v.y, v.z, v.x};
  }
  return out;
}

}  // namespace fccda
