#include "perimpact/discretisation/surface_solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/contract.hpp"
#include "base/error.hpp"
#include "mesh/ray_crossing.hpp"
#include "mesh/search/closest_point.hpp"
#include "perimpact/discretisation/panels_of_file.hpp"

namespace perimpact {

using namespace fccda;

namespace {

/// Crossing at which the line enters (1) or leaves (-1) a solid.
struct LineCrossing {
  double x;  ///< [m]
  int change;
  friend bool operator<(const LineCrossing& a, const LineCrossing& b) { return a.x != b.x ? a.x < b.x : a.change > b.change; }
};

Corners corners_of(const Surface& surface, std::size_t t) { return {surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)}; }

/// x of the triangle's plane at this y and z, clamped to the triangle, since rounding is large for one nearly parallel to x.
double crossing_x(const Corners& t, double y, double z) {
  const Vec3d normal = cross(t.b - t.a, t.c - t.a);
  const double x = t.a.x + ((t.a.y - y) * normal.y + (t.a.z - z) * normal.z) / normal.x;
  return std::clamp(x, std::min({t.a.x, t.b.x, t.c.x}), std::max({t.a.x, t.b.x, t.c.x}));
}

Panels placed(Panels panels, const Frame& frame) {
  for (Vec3d& vertex : panels.vertices) vertex = frame.to_world(vertex);
  return panels;
}

std::shared_ptr<const Surface> closed_surface(const Panels& panels, double weld, const std::string& name) {
  // the orientation is declared, so that an open surface is reported here instead of in Surface
  auto surface = std::make_shared<const Surface>(panels, Surface::Options{.weld_distance = weld, .orientation = Orientation::normals, .name = name});
  if (!surface->is_closed())
    throw InputError(
        fmt::format("{}: the surface is open: {} of its edges have a panel on one side only, so that no interior is defined; `perimpact mesh` shows these "
                    "edges and the welding tolerance that would close them.",
                    name, surface->report().boundary_edges));
  return surface;
}

}  // namespace

SurfaceSolid::SurfaceSolid(const FileSurface& setup, const Frame& frame)
    : SurfaceSolid(placed(panels_of_file(setup), frame), setup.weld.value_or(0), setup.file) {}

SurfaceSolid::SurfaceSolid(const Panels& panels, double weld, const std::string& name)
    : surface_(closed_surface(panels, weld, name)), tree_(std::make_shared<const Bvh>(*surface_)) {}

std::optional<double> SurfaceSolid::volume() const {
  if (surface_->report().may_overlap > 0) return std::nullopt;
  return surface_->report().volume;
}

void SurfaceSolid::mark(const Row& row, double margin, std::span<std::uint8_t> inside, std::uint8_t mark) const {
  EXPECTS(inside.size() == static_cast<std::size_t>(row.count));
  const Box bounds = this->bounds();
  const double y = row.first.y, z = row.first.z;
  if (y < bounds.low.y - margin || y > bounds.high.y + margin || z < bounds.low.z - margin || z > bounds.high.z + margin) return;
  if (row.x(0) > bounds.high.x + margin || row.x(row.count - 1) < bounds.low.x - margin) return;

  const auto number_at = [&](double x) {  // number of the first point not before x
    const double number = row.count > 1 ? std::ceil((x - row.first.x) / row.spacing) - row.begin : (x > row.x(0) ? 1 : 0);
    return static_cast<int>(std::clamp(number, 0.0, static_cast<double>(row.count)));
  };
  const RayCrossing crosses(surface_->vertices(), surface_->triangles());
  const Vec3d before{bounds.low.x - 1 - bounds.size().x, y, z};
  std::vector<LineCrossing> crossings;
  int balance = 0;
  const auto add_triangle = [&](int triangle) {
    const auto t = static_cast<std::size_t>(triangle);
    const Corners corners = corners_of(*surface_, t);
    if (const int out = crosses(before, t); out != 0) {
      crossings.push_back({crossing_x(corners, y, z), -out});
      balance += out;
    }
    const double low = std::min({corners.a.x, corners.b.x, corners.c.x}) - margin, high = std::max({corners.a.x, corners.b.x, corners.c.x}) + margin;
    for (int i = number_at(low); i < row.count && row.x(i) <= high; ++i)
      if (squared_norm(row.point(i) - closest_on_triangle(row.point(i), corners).point) <= margin * margin) inside[static_cast<std::size_t>(i)] = mark;
  };
  const Vec3d around{margin, margin, margin};
  tree_->visit_box({Vec3d{bounds.low.x, y, z} - around, Vec3d{bounds.high.x, y, z} + around}, add_triangle);

  if (balance != 0) {  // rounding: the line missed a nearly coplanar sliver
    for (int i = 0; i < row.count; ++i)
      if (winding(row.point(i)) > 0.5) inside[static_cast<std::size_t>(i)] = mark;
    return;
  }
  std::sort(crossings.begin(), crossings.end());
  int depth = 0;
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    depth += crossings[c].change;
    if (depth <= 0) continue;
    for (int i = number_at(crossings[c].x); i < number_at(crossings[c + 1].x); ++i) inside[static_cast<std::size_t>(i)] = mark;
  }
}

double SurfaceSolid::winding(const Vec3d& point) const {
  double angle = 0;
  for (std::size_t t = 0; t < surface_->triangles().size(); ++t) {
    const Vec3d a = surface_->corner(t, 0) - point, b = surface_->corner(t, 1) - point, c = surface_->corner(t, 2) - point;
    const double na = norm(a), nb = norm(b), nc = norm(c);
    angle += 2 * std::atan2(dot(a, cross(b, c)), na * nb * nc + dot(a, b) * nc + dot(b, c) * na + dot(c, a) * nb);
  }
  return angle / (4 * std::numbers::pi);
}

}  // namespace perimpact
