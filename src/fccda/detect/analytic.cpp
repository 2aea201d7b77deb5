#include "fccda/detect/analytic.hpp"

#include <algorithm>
#include <cmath>

namespace fccda {

bool Analytic::is_inside(const Vec3d& point) const {
  const double radius = shape_radius();
  const Vec3d from = from_centre(point);
  const double distance = norm(from);
  const Vec3d on_surface = distance > 0 ? point - (1 - radius / distance) * from : point;
  return distance < radius + radius_ - 1e-9 * radius && std::visit([&](const auto& region) { return region.contains(on_surface); }, region_);
}

std::vector<std::optional<Vec3d>> Analytic::nearest_outside(std::span<const Vec3d> points, const Pose& pose) const {
  const double reach = (shape_radius() + radius_) * (1 + 1e-12);
  std::vector<std::optional<Vec3d>> places;
  for (const Vec3d& point : points) {
    const Vec3d place = pose.to_body(point), from = from_centre(place);
    const double distance = norm(from);
    places.push_back(distance > 0 ? std::optional(pose.to_world(place + (reach / distance - 1) * from)) : std::nullopt);
  }
  return places;
}

void Analytic::evaluate(std::size_t point, const Vec3d& position_t0, const Vec3d& position_t1, const Motion& motion, Found& found) const {
  const Path path{motion.t0.to_body(position_t0), motion.t1.to_body(position_t1)};
  const double reach = shape_radius() + radius_;
  const double offset = 1e-12 * reach;
  if (!std::visit([&](const auto& region) { return region.may_contact(path, radius_ + offset); }, region_)) return;
  ++found.effort.points_in_bounds;
  ++found.effort.points_tested;

  // |a + f w| <= reach, with a and w the components of the start and of the path off the centre or axis
  const Vec3d a = from_centre(path.start), z = from_centre(path.end), w = z - a;
  const double aw = dot(a, w), ww = squared_norm(w), end = norm(z);
  const double nearest = ww > 0 ? std::clamp(-aw / ww, 0.0, 1.0) : 0.0;
  const double limit = reach - offset;
  const bool through = end >= limit && dot(a, z) < 0;
  if (!(end < limit || (through && norm(a + nearest * w) < limit))) return;
  const double before = squared_norm(a) - reach * reach;
  if (before < 0 && through) return;  // starts inside and leaves
  const double discriminant = aw * aw - ww * before;
  const double first = before > 0 && ww > 0 ? std::clamp((-aw - std::sqrt(std::max(0.0, discriminant))) / ww, 0.0, 1.0) : 0.0;

  const Vec3d contact_direction = normalised(a + first * w);
  const Vec3d hit = path.at(first) - (norm(a + first * w) - shape_radius()) * contact_direction;
  if (!std::visit([&](const auto& region) { return region.contains(hit); }, region_)) return;

  Vec3d normal = normalised(z), place = path.end + (reach + offset - end) * normal;
  if (dot(a, z) <= 0) normal = contact_direction, place = path.at(first) + offset * contact_direction;
  constexpr double in_contact = 0.01;  // of the way, as in relocation.cpp
  const double start = norm(a);
  const bool began = start >= reach - offset && start <= reach + offset + in_contact * path.length() && dot(a, z) > 0;
  found.contacts.push_back({.point = point,
                            .panel = -1,
                            .time_fraction = first,
                            .hit = motion.t1.to_world(hit),
                            .normal = motion.t1.turn_to_world(normal),
                            .relocation = motion.t1.to_world(place),
                            .depth = norm(place - path.end),
                            .radius = radius_,
                            .normal_t0 = began ? motion.t0.turn_to_world(a / start) : Vec3d{}});
}

}  // namespace fccda
