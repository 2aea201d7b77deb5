#include "io/report/rigid_motion.hpp"

#include <array>

namespace perimpact::report {

namespace {

using fccda::Mat3;
using fccda::Vec3d;

/// The indices of three points that span a large triangle.
std::array<std::size_t, 3> corners_of(std::span<const Vec3d> points) {
  std::array<std::size_t, 3> corners{};
  const auto farthest = [&](const auto& distance) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (distance(points[i]) > distance(points[found])) found = i;
    return found;
  };
  corners[1] = farthest([&](const Vec3d& point) { return fccda::squared_norm(point - points[corners[0]]); });
  const Vec3d along = points[corners[1]] - points[corners[0]];
  corners[2] = farthest([&](const Vec3d& point) { return fccda::squared_norm(fccda::cross(along, point - points[corners[0]])); });
  return corners;
}

/// Orthonormal right-handed axes attached to three points, as columns.
Mat3 axes_of(std::span<const Vec3d> points, const std::array<std::size_t, 3>& corners) {
  const Vec3d along = fccda::normalised(points[corners[1]] - points[corners[0]]);
  const Vec3d upright = fccda::normalised(fccda::cross(along, points[corners[2]] - points[corners[0]]));
  return fccda::transpose(Mat3{{along, fccda::cross(upright, along), upright}});
}

}  // namespace

std::optional<RigidMotion> rigid_motion(std::span<const Vec3d> from, std::span<const Vec3d> to, double tolerance) {
  if (from.size() != to.size() || from.empty()) return {};
  const std::array<std::size_t, 3> corners = corners_of(from);
  RigidMotion motion{.turn = axes_of(to, corners) * fccda::transpose(axes_of(from, corners)), .shift = {}};
  motion.shift = to[corners[0]] - motion.turn * from[corners[0]];
  for (std::size_t i = 0; i < from.size(); ++i)
    if (!(fccda::norm(motion.turn * from[i] + motion.shift - to[i]) <= tolerance)) return {};
  return motion;
}

}  // namespace perimpact::report
