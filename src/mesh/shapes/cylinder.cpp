#include "mesh/shapes/cylinder.hpp"

#include "mesh/part_naming.hpp"
#include "mesh/shapes/rings.hpp"

namespace fccda {

Panels make_cylinder(const CylinderShape& shape) {
  expect_sizes({shape.diameter, shape.height}, shape.edge_length, "cylinder");
  const double panel = shape.edge_length > 0 ? shape.edge_length : shape.diameter / 20;
  const double radius = 0.5 * shape.diameter;
  const double columns = circle_divisions(radius, panel), rows = divisions(shape.height, panel);
  // rings of the caps have about as many vertices as their circumference has panels
  expect_affordable(2 * columns * (rows + divisions(radius, panel)), panel, "cylinder");

  Panels out;
  PartNaming parts(out);
  parts.begin("bottom");
  Ring below = add_ring(out, static_cast<int>(columns), radius, -0.5 * shape.height);
  add_cap(out, below, radius, -0.5 * shape.height, panel, Facing::down);
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
  add_cap(out, below, radius, 0.5 * shape.height, panel, Facing::up);
  parts.finish();

  turn_axis(out, shape.axis);
  return out;
}

}  // namespace fccda
