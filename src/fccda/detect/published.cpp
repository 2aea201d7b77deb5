#include "fccda/detect/published.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/search/closest_point.hpp"

namespace fccda {

namespace {

double triangle_area(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c) {
  return 0.5 * std::fabs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

/// Eq. 15 with the projection along `axis`: whether the areas of the point with the panel's edges add up to the panel's.
bool areas_agree(const std::array<Vec3d, 4>& node, std::size_t nodes, const Vec3d& point, std::size_t axis) {
  constexpr double infinitesimal = 1e-9;  // of the panel's area
  const auto project = [&](const Vec3d& p) { return std::array{p[(axis + 1) % 3], p[(axis + 2) % 3]}; };
  const std::array<double, 2> p = project(point);
  double panel = triangle_area(project(node[0]), project(node[1]), project(node[2]));
  if (nodes == 4) panel += triangle_area(project(node[2]), project(node[3]), project(node[0]));
  double spanned = 0;
  for (std::size_t k = 0; k < nodes; ++k) spanned += triangle_area(project(node[k]), project(node[(k + 1) % nodes]), p);
  return std::fabs(panel - spanned) <= infinitesimal * panel;
}

bool within(double value, double low, double high) { return value >= low && value <= high; }

}  // namespace

void Rejections::count(Verdict verdict) {
  by_eq14 += verdict == Verdict::eq14;
  by_eq15 += verdict == Verdict::eq15;
  by_eq17 += verdict == Verdict::eq17;
  by_eq20 += verdict == Verdict::eq20;
}

Published::Published(std::shared_ptr<const Surface> surface, const ContactBounds& region, Variant variant)
    : surface_(std::move(surface)),
      region_(region),
      variant_(variant),
      sign_(surface_->panels().panels.size(), 1),
      sides_(std::make_shared<const PathTest>(surface_, region_, 0)) {
  // Panels may have either winding in the file; the surface knows its outside, and which panels it dropped.
  std::vector<int> sign(sign_.size(), 0);
  for (std::size_t t = 0; t < surface_->triangles().size(); ++t) {
    const auto panel = static_cast<std::size_t>(surface_->triangles()[t].panel);
    sign[panel] = dot(plane(panel, Pose()).normal, surface_->normal(t)) < 0 ? -1 : 1;
  }
  sign_ = sign;
}

Published::Plane Published::plane(std::size_t panel, const Pose& pose) const {
  Plane its;
  if (sign_[panel] == 0) return its;
  const std::array<int, 4>& vertex = surface_->panels().panels[panel];
  its.nodes = vertex[3] < 0 ? 3 : 4;
  for (std::size_t k = 0; k < its.nodes; ++k) {
    its.node[k] = pose.to_world(surface_->panels().vertices[static_cast<std::size_t>(vertex[k])]);
    its.box.include(its.node[k]);
  }
  // Eq. 16: the product of the diagonals, which is (twice) the area vector for a warped quad too.
  const Vec3d area = its.nodes == 4 ? cross(its.node[2] - its.node[0], its.node[3] - its.node[1]) : cross(its.node[1] - its.node[0], its.node[2] - its.node[0]);
  its.normal = sign_[panel] * normalised(area);
  its.d = -dot(its.normal, its.node[0]);
  return its;
}

void Published::place(const Motion& motion) {
  at_t0_.resize(sign_.size());
  at_t1_.resize(sign_.size());
  parallel_for(static_cast<std::ptrdiff_t>(sign_.size()), [&](std::ptrdiff_t k) {
    const auto panel = static_cast<std::size_t>(k);
    at_t0_[panel] = plane(panel, motion.t0);
    at_t1_[panel] = plane(panel, motion.t1);
  });
}

Verdict Published::judge_literal(const Planes& panel, const Vec3d& x_t0, const Vec3d& x_t1, const Motion& motion) {
  const auto& [before, after] = panel;
  if (!within(x_t0.y, before.box.low.y, before.box.high.y) || !within(x_t0.z, before.box.low.z, before.box.high.z)) return Verdict::eq14;
  if (!areas_agree(before.node, before.nodes, x_t0, 2)) return Verdict::eq15;
  const double height_t0 = before.height(x_t0), height_t1 = after.height(x_t1);
  if (!(height_t0 <= 0 && height_t1 > 0) && !(height_t0 >= 0 && height_t1 < 0)) return Verdict::eq17;
  const bool above = x_t0.y > motion.t0.position().y;
  if (above ? !(height_t0 >= 0) : !(height_t0 <= 0)) return Verdict::eq20;
  return Verdict::accepted;
}

Verdict Published::judge_corrected(const Planes& panel, const Vec3d& x_t0, const Vec3d& x_t1) {
  const auto& [before, after] = panel;
  const Vec3d low = min(x_t0, x_t1), high = max(x_t0, x_t1);
  const Vec3d panel_low = min(before.box.low, after.box.low), panel_high = max(before.box.high, after.box.high);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (low[axis] > panel_high[axis] || high[axis] < panel_low[axis]) return Verdict::eq14;
  const Vec3d n = after.normal;
  const double largest = largest_magnitude(n);
  const std::size_t along = std::fabs(n.x) == largest ? 0 : std::fabs(n.y) == largest ? 1 : 2;
  if (!areas_agree(after.node, after.nodes, x_t1, along)) return Verdict::eq15;
  if (!(before.height(x_t0) >= 0 && after.height(x_t1) < 0)) return Verdict::eq17;
  return Verdict::accepted;
}

// Eqs. 18 and 19.
Vec3d Published::relocated(const Plane& plane, const Vec3d& x_t1) const {
  const Vec3d on_plane = x_t1 - plane.height(x_t1) * plane.normal;
  if (variant_ == Variant::literal) return on_plane;
  Vec3d best = closest_on_triangle(on_plane, {plane.node[0], plane.node[1], plane.node[2]}).point;
  if (plane.nodes == 4) {
    const Vec3d other = closest_on_triangle(on_plane, {plane.node[2], plane.node[3], plane.node[0]}).point;
    if (squared_norm(on_plane - other) < squared_norm(on_plane - best)) best = other;
  }
  return best + 1e-12 * largest_magnitude(surface_->report().bounds.size()) * plane.normal;
}

void Published::evaluate(std::size_t point, const Vec3d& x_t0, const Vec3d& x_t1, const Motion& motion, Found& found) const {
  const Path path{motion.t0.to_body(x_t0), motion.t1.to_body(x_t1)};
  if (!std::visit([&](const auto& region) { return region.may_contact(path, 0); }, region_)) return;
  const Box& bounds = surface_->report().bounds;
  const Vec3d low = min(path.start, path.end), high = max(path.start, path.end);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(low[axis] <= bounds.high[axis] && high[axis] >= bounds.low[axis])) return;
  ++found.effort.points_in_bounds;
  ++found.effort.points_tested;
  for (std::size_t panel = 0; panel < sign_.size(); ++panel) {
    if (sign_[panel] == 0) continue;
    ++found.effort.panels_tested;
    const Verdict verdict = judge({at_t0_[panel], at_t1_[panel]}, x_t0, x_t1, motion);
    found.rejections.count(verdict);
    if (verdict != Verdict::accepted) continue;
    const Plane& plane = at_t1_[panel];
    const double before = at_t0_[panel].height(x_t0), after = plane.height(x_t1);
    const double fraction = before / (before - after);
    const Vec3d place = relocated(plane, x_t1);
    found.contacts.push_back({.point = point,
                              .panel = static_cast<int>(panel),
                              .time_fraction = fraction,
                              .hit = motion.t1.to_world(path.at(fraction)),
                              .normal = plane.normal,
                              .relocation = place,
                              .depth = norm(place - x_t1)});
    return;  // figure 12: the first panel that is penetrated ends the loop
  }
}

}  // namespace fccda
