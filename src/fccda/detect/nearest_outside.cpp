#include "fccda/detect/nearest_outside.hpp"

#include <algorithm>
#include <limits>

namespace fccda {

std::optional<Vec3d> nearest_outside(const PathTest& test, const Vec3d& point) {
  const Surface& surface = test.surface();
  // rounding of the position itself, and of its distance in a later query
  const double offset = std::max(1e-12 * test.size(), 32 * std::numeric_limits<double>::epsilon() * largest_magnitude(point));
  constexpr int most_projections = 10;
  Vec3d place = point;
  for (int projection = 0; projection < most_projections; ++projection) {
    std::size_t tested = 0;
    const std::optional<PathTest::Nearest> nearest = test.nearest(place, -1, tested);
    if (!nearest) return std::nullopt;
    const ClosestPoint& closest = nearest->closest;
    const Vec3d& normal = surface.pseudonormal(static_cast<std::size_t>(closest.triangle), closest.feature);
    Vec3d direction = normal;
    if (closest.distance > offset) {
      direction = (place - closest.point) / closest.distance;
      if (dot(direction, normal) < 0) direction = -direction;
    }
    place = closest.point + (test.radius() + offset) * direction;
    if (!test.is_inside(place, offset)) return place;
  }
  return std::nullopt;
}

std::vector<std::optional<Vec3d>> nearest_outside(const PathTest& test, std::span<const Vec3d> points, const Pose& pose) {
  std::vector<std::optional<Vec3d>> places;
  for (const Vec3d& point : points) {
    places.push_back(nearest_outside(test, pose.to_body(point)));
    if (places.back()) places.back() = pose.to_world(*places.back());
  }
  return places;
}

}  // namespace fccda
