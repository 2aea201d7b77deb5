#include "perimpact/discretisation/solid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace perimpact {

using fccda::Box;

namespace {

std::size_t axis_of(const CylinderSolid& cylinder) { return static_cast<std::size_t>(cylinder.axis.index); }

bool contains(const BoxSolid& box, const Vec3d& p, double margin) {
  const auto within = [&](std::size_t axis) { return std::fabs(p[axis]) <= 0.5 * box.size[axis] + margin; };
  return within(0) && within(1) && within(2);
}

bool contains(const CylinderSolid& cylinder, const Vec3d& p, double margin) {
  const std::size_t axis = axis_of(cylinder);
  if (std::fabs(p[axis]) > 0.5 * cylinder.height + margin) return false;
  const double u = p[(axis + 1) % 3], v = p[(axis + 2) % 3], radius = 0.5 * cylinder.diameter + margin, squared = u * u + v * v;
  constexpr double near = 1e-6;  // only there the rounding of the root matters
  if (squared > (1 + near) * radius * radius) return false;
  return squared < (1 - near) * radius * radius || std::hypot(u, v) <= radius;
}

bool contains(const SphereSolid& sphere, const Vec3d& p, double margin) { return norm(p) <= 0.5 * sphere.diameter + margin; }

/// Half the size of the global bounding box of the rotated shape.
Vec3d half_extent(const BoxSolid& box, const fccda::Mat3& turn) {
  Vec3d half{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < 3; ++k) half[axis] += std::fabs(turn.row[axis][k]) * 0.5 * box.size[k];
  return half;
}

Vec3d half_extent(const CylinderSolid& cylinder, const fccda::Mat3& turn) {
  Vec3d half{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double cosine = std::fabs(turn.row[axis][axis_of(cylinder)]);
    half[axis] = 0.5 * (cosine * cylinder.height + std::sqrt(std::max(0.0, 1 - cosine * cosine)) * cylinder.diameter);
  }
  return half;
}

Vec3d half_extent(const SphereSolid& sphere, const fccda::Mat3&) { return 0.5 * sphere.diameter * Vec3d{1, 1, 1}; }

double volume_of(const BoxSolid& box) { return box.size.x * box.size.y * box.size.z; }
double volume_of(const CylinderSolid& cylinder) { return 0.25 * std::numbers::pi * cylinder.diameter * cylinder.diameter * cylinder.height; }
double volume_of(const SphereSolid& sphere) { return std::numbers::pi / 6 * sphere.diameter * sphere.diameter * sphere.diameter; }

template <class Shape>
constexpr bool is_surface = std::is_same_v<Shape, SurfaceSolid>;

}  // namespace

Solid::Solid(const SolidShape& shape, const Frame& frame) : frame_(frame) {
  std::visit(
      [&]<class Shape>(const Shape& given) {
        if constexpr (std::is_same_v<Shape, FileSolid>) {
          const auto& surface = shape_.template emplace<SurfaceSolid>(given, frame);
          bounds_ = surface.bounds();
          volume_ = surface.volume();
        } else {
          shape_ = given;
          const Vec3d half = half_extent(given, frame.turn);
          bounds_ = {frame.origin - half, frame.origin + half};
          volume_ = volume_of(given);
        }
      },
      shape);
}

bool Solid::contains(const Vec3d& point, double margin) const {
  std::uint8_t inside = 0;
  mark({.first = point}, margin, {&inside, 1}, 1);
  return inside != 0;
}

void Solid::mark(const Row& row, double margin, std::span<std::uint8_t> inside, std::uint8_t mark) const {
  std::visit(
      [&]<class Shape>(const Shape& shape) {
        if constexpr (is_surface<Shape>) {
          shape.mark(row, margin, inside, mark);
        } else {
          // rows and points beyond the bounds, with room for rounding, need no test
          const double room = 2 * margin + 1e-9 * std::max(fccda::largest_magnitude(bounds_.low), fccda::largest_magnitude(bounds_.high));
          const Vec3d low = bounds_.low - Vec3d{room, room, room}, high = bounds_.high + Vec3d{room, room, room};
          if (row.first.y < low.y || row.first.y > high.y || row.first.z < low.z || row.first.z > high.z) return;
          for (int i = 0; i < row.count; ++i)
            if (row.x(i) >= low.x && row.x(i) <= high.x && perimpact::contains(shape, frame_.to_local(row.point(i)), margin))
              inside[static_cast<std::size_t>(i)] = mark;
        }
      },
      shape_);
}

}  // namespace perimpact
