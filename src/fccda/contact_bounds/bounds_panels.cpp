#include "fccda/contact_bounds/bounds_panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fccda {

namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr int circle_edges = 72;

Panels panels_of(const Unbounded&) { return {}; }
Panels panels_of(const BoxUnion& boxes) { return fccda::panels_of(boxes.boxes()); }

/// A closed sector of a ring between two radii, over the length of the cylinder.
struct RingPart {
  double inner, outer;    // [m]
  double start, opening;  // [rad]
  double half_length;     // [m]
};

void add(const RingPart& part, const CylinderFrame& frame, Panels& panels) {
  const bool is_ring = part.opening >= turn;
  const int edges = std::max(1, static_cast<int>(std::ceil(circle_edges * part.opening / turn)));
  const int first = static_cast<int>(panels.vertices.size());
  for (int k = 0; k <= edges; ++k) {
    const double angle = part.start + part.opening * k / edges, x = std::cos(angle), y = std::sin(angle);
    for (const double r : {part.inner, part.outer})
      for (const double z : {-part.half_length, part.half_length}) panels.vertices.push_back(frame.to_body({r * x, r * y, z}));
  }
  // four corners at each angle: inner low, inner high, outer low, outer high
  const auto at = [&](int k, int corner) { return first + 4 * k + corner; };
  for (int k = 0; k < edges; ++k) {
    panels.add_quad(at(k, 2), at(k + 1, 2), at(k + 1, 3), at(k, 3));
    panels.add_quad(at(k, 1), at(k, 3), at(k + 1, 3), at(k + 1, 1));
    panels.add_quad(at(k, 0), at(k + 1, 0), at(k + 1, 2), at(k, 2));
    if (part.inner > 0) panels.add_quad(at(k, 0), at(k, 1), at(k + 1, 1), at(k + 1, 0));
  }
  if (is_ring) return;
  panels.add_quad(at(0, 0), at(0, 2), at(0, 3), at(0, 1));
  panels.add_quad(at(edges, 0), at(edges, 1), at(edges, 3), at(edges, 2));
}

Panels panels_of(const CylinderSectors& region) {
  const CylinderSectors::Shape& shape = region.shape();
  const CylinderFrame frame(shape.point, shape.axis);
  const double half_length = 0.5 * shape.length;
  Panels panels;
  const double hub = shape.has_gaps() ? shape.hub_radius : shape.radius;
  if (hub > 0) add({0, hub, 0, turn, half_length}, frame, panels);
  for (int blade = 0; shape.has_gaps() && blade < shape.blades; ++blade)
    add({hub, shape.radius, shape.start_angle + turn * blade / shape.blades, shape.sector_angle, half_length}, frame, panels);
  return panels;
}

}  // namespace

Panels panels_of(std::span<const Box> boxes) {
  Panels all;
  for (const Box& box : boxes) {
    const int first = static_cast<int>(all.vertices.size());
    for (int corner = 0; corner < 8; ++corner) {  // bits of the corner: x, y, z high
      all.vertices.push_back({corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y, corner & 4 ? box.high.z : box.low.z});
    }
    for (const auto& [a, b, c, d] : {std::array{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
      all.add_quad(first + a, first + b, first + c, first + d);
    }
  }
  return all;
}

Panels bounds_panels(const ContactBounds& region) {
  return std::visit([](const auto& its) { return panels_of(its); }, region);
}

}  // namespace fccda
