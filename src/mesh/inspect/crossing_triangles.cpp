#include "mesh/inspect/crossing_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fccda {
namespace {

constexpr double shortest_crossing = 1e-9;  // relative to the longest edge; shorter crossings may be rounding error

std::array<int, 3> sides_of(const TriangleCorners& corners, const TriangleCorners& plane) {
  std::array<int, 3> sides{};
  for (std::size_t c = 0; c < 3; ++c) sides[c] = side_of_plane(plane[0], plane[1], plane[2], corners[c]);
  return sides;
}

bool are_on_both(const std::array<int, 3>& sides) {
  const auto [lowest, highest] = std::minmax_element(sides.begin(), sides.end());
  return *lowest < 0 && *highest > 0;
}

Vec3d doubled_area(const TriangleCorners& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// The intersection of a triangle with a plane, from end to end.
using Piece = std::array<Vec3d, 2>;

Piece fragment_of(const TriangleCorners& corners, const std::array<int, 3>& sides, const TriangleCorners& plane) {
  const Vec3d normal = doubled_area(plane);
  Piece piece{};
  std::size_t ends = 0;
  for (std::size_t c = 0; c < 3 && ends < 2; ++c) {
    const std::size_t next = (c + 1) % 3;
    if (sides[c] == 0) piece[ends++] = corners[c];
    if (sides[c] * sides[next] >= 0) continue;
    const double here = std::fabs(dot(corners[c] - plane[0], normal)), there = std::fabs(dot(corners[next] - plane[0], normal));
    piece[ends++] = corners[c] + here / (here + there) * (corners[next] - corners[c]);
  }
  return piece;
}

double longest_edge(const TriangleCorners& t) { return std::sqrt(std::max({squared_norm(t[1] - t[0]), squared_norm(t[2] - t[1]), squared_norm(t[0] - t[2])})); }

}  // namespace

int side_of_plane(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const Vec3d ad = a - d, bd = b - d, cd = c - d;
  const double bc = bd.x * cd.y - cd.x * bd.y, ca = cd.x * ad.y - ad.x * cd.y, ab = ad.x * bd.y - bd.x * ad.y;
  const double determinant = ad.z * bc + bd.z * ca + cd.z * ab;
  const double permanent = (std::fabs(bd.x * cd.y) + std::fabs(cd.x * bd.y)) * std::fabs(ad.z) +
                           (std::fabs(cd.x * ad.y) + std::fabs(ad.x * cd.y)) * std::fabs(bd.z) +
                           (std::fabs(ad.x * bd.y) + std::fabs(bd.x * ad.y)) * std::fabs(cd.z);
  constexpr double half_ulp = 0.5 * std::numeric_limits<double>::epsilon();
  constexpr double bound = (7 + 56 * half_ulp) * half_ulp;
  if (!(std::fabs(determinant) > bound * permanent)) return 0;
  return determinant < 0 ? 1 : -1;  // of points above the plane the determinant is negative
}

std::optional<Vec3d> crossing_of(const TriangleCorners& one, const TriangleCorners& other) {
  const std::array<int, 3> of_one = sides_of(one, other);
  if (!are_on_both(of_one)) return std::nullopt;
  const std::array<int, 3> of_other = sides_of(other, one);
  if (!are_on_both(of_other)) return std::nullopt;
  // Both triangles intersect the line common to their planes; they cross if the two intervals on it overlap.
  const Vec3d line = cross(doubled_area(one), doubled_area(other));
  const double length = norm(line);
  if (!(length > 0)) return std::nullopt;
  std::array<Piece, 2> pieces{fragment_of(one, of_one, other), fragment_of(other, of_other, one)};
  const Vec3d origin = pieces[0][0];
  const auto along = [&](const Vec3d& p) { return dot(p - origin, line) / length; };
  for (Piece& piece : pieces)
    if (along(piece[0]) > along(piece[1])) std::swap(piece[0], piece[1]);
  const Vec3d& begin = along(pieces[0][0]) > along(pieces[1][0]) ? pieces[0][0] : pieces[1][0];
  const Vec3d& end = along(pieces[0][1]) < along(pieces[1][1]) ? pieces[0][1] : pieces[1][1];
  if (!(along(end) - along(begin) > shortest_crossing * std::max(longest_edge(one), longest_edge(other)))) return std::nullopt;
  return 0.5 * (begin + end);
}

}  // namespace fccda
