#include "mesh_io/file/cells.hpp"

#include <algorithm>
#include <cmath>

namespace fccda {

namespace {

/// Relative to the extent, cubed or squared; smaller measures are rounding error.
constexpr double nothing = 1e-12;

Vec3d middle_of(std::span<const Vec3d> points) {
  Vec3d sum{};
  for (const Vec3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

double size_of(std::span<const Vec3d> corners) {
  double size = 0;
  for (const Vec3d& corner : corners) size = std::max(size, norm(corner - corners[0]));
  return size;
}

std::optional<Cell> solid_cell(ElementKind kind, std::span<const Vec3d> corners) {
  const Vec3d centre = middle_of(corners);
  const double size = size_of(corners), least = nothing * size * size * size;
  double outward = 0, inward = 0;  // sums of the positive and the negative tetrahedron volumes
  Vec3d moment{};
  const auto faces = faces_of(kind);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::size_t count = faces[f][3] < 0 ? 3 : 4;
    std::array<Vec3d, 4> face;
    for (std::size_t k = 0; k < count; ++k) face[k] = corners[static_cast<std::size_t>(faces[f][f == 0 ? count - 1 - k : k])];
    const Vec3d middle = middle_of(std::span(face).first(count));
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3d &a = face[k], &b = face[(k + 1) % count];
      const double part = dot(middle - centre, cross(a - centre, b - centre)) / 6;
      (part > 0 ? outward : inward) += part;
      moment += part * (0.25 * (centre + middle + a + b) - centre);
    }
  }
  const double volume = outward + inward;
  constexpr double folded = 1e-3;  // fraction of the volume: a warped face may be slightly concave
  if (!(std::fabs(volume) > least) || std::min(-inward, outward) > folded * std::fabs(volume)) return std::nullopt;
  return Cell{std::fabs(volume), centre + moment / volume};
}

std::optional<Cell> surface_cell(std::span<const Vec3d> corners) {
  Vec3d area{};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) area += 0.5 * cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
  const double size = size_of(corners), total = norm(area);
  if (!(total > nothing * size * size)) return std::nullopt;
  Vec3d moment{};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const double part = 0.5 * dot(cross(corners[k] - corners[0], corners[k + 1] - corners[0]), area) / total;
    moment += part / 3 * (corners[k] + corners[k + 1] - 2 * corners[0]);
  }
  return Cell{total, corners[0] + moment / total};
}

}  // namespace

std::optional<Cell> cell_of(ElementKind kind, std::span<const Vec3d> corners) { return is_solid(kind) ? solid_cell(kind, corners) : surface_cell(corners); }

}  // namespace fccda
