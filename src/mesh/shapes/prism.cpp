#include "mesh/shapes/prism.hpp"

#include <cmath>

#include "mesh/add_polygon.hpp"
#include "mesh/shapes/divisions.hpp"
#include "mesh/shapes/refuse.hpp"

namespace fccda {
namespace {

/// Twice the area of three corners of the end, positive if counterclockwise.
double doubled_area(const Panels& panels, int a, int b, int c) {
  const auto at = [&](int vertex) { return panels.vertices[static_cast<std::size_t>(vertex)]; };
  return cross(at(b) - at(a), at(c) - at(a)).z;
}

/// False if sides cross. A quad is split here, along the diagonal inside it.
bool add_end(Panels& out, const std::vector<int>& corners) {
  if (corners.size() != 4) return add_polygon(out, corners);
  for (std::size_t first = 0; first < 2; ++first) {
    const int a = corners[first], b = corners[first + 1], c = corners[first + 2], d = corners[(first + 3) % 4];
    if (!(doubled_area(out, a, b, c) * doubled_area(out, a, c, d) > 0)) continue;
    out.add_triangle(a, b, c);
    out.add_triangle(a, c, d);
    return true;
  }
  return false;
}

}  // namespace

Panels make_prism(const PrismShape& shape) {
  expect_sizes({shape.height}, 0, "prism");
  const auto count = static_cast<int>(shape.outline.size());
  Panels out;
  std::vector<int> bottom, top;
  for (int k = 0; k < count; ++k) {
    const auto [x, y] = shape.outline[static_cast<std::size_t>(k)];
    if (!std::isfinite(x) || !std::isfinite(y)) refuse_shape("prism", "corner ", k, " of the outline is at (", x, ", ", y, "), but it must be finite.");
    out.vertices.push_back({x, y, -0.5 * shape.height});
    out.vertices.push_back({x, y, 0.5 * shape.height});
    bottom.insert(bottom.begin(), 2 * k);
    top.push_back(2 * k + 1);
  }
  if (count < 3 || !add_end(out, top) || !add_end(out, bottom))
    refuse_shape("prism", "the outline of ", count, " corners encloses no area; it needs three corners or more, and its sides must not cross.");
  for (int k = 0; k < count; ++k) {
    const int next = (k + 1) % count;
    out.add_quad(2 * k, 2 * next, 2 * next + 1, 2 * k + 1);
  }
  return out;
}

}  // namespace fccda
