#include "fccda/surface/add_polygon.hpp"

#include <algorithm>
#include <vector>

namespace fccda {
namespace {

constexpr double rounding = 1e-12;  // of corners on a line

class Polygon {
 public:
  Polygon(const std::vector<Vec3d>& vertices, std::span<const int> corners) : vertices_(vertices), corners_(corners) {
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) whole_ += doubled_area(0, k, k + 1);
  }

  /// Are the triangles from the first corner all seen from the same side?
  bool is_fan() const {
    for (std::size_t k = 1; k + 1 < corners_.size(); ++k) {
      const Vec3d area = doubled_area(0, k, k + 1);
      if (whole_ == Vec3d{} ? area != Vec3d{} : seen(area) < -rounding) return false;
    }
    return true;
  }

  bool has_area() const { return whole_ != Vec3d{}; }

  /// Corner numbers, three a triangle; fewer than all where no ear is left.
  std::vector<std::size_t> ears() const {
    std::vector<std::size_t> rest(corners_.size()), triangles;
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = k;
    for (std::size_t since_last = 0, k = 0; rest.size() > 3 && since_last < rest.size();) {
      const std::size_t before = rest[(k + rest.size() - 1) % rest.size()], here = rest[k], after = rest[(k + 1) % rest.size()];
      if (is_ear(rest, before, here, after)) {
        triangles.insert(triangles.end(), {before, here, after});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
        since_last = 0;
        k %= rest.size();
      } else {
        ++since_last;
        k = (k + 1) % rest.size();
      }
    }
    if (rest.size() == 3 && seen(doubled_area(rest[0], rest[1], rest[2])) >= -rounding) triangles.insert(triangles.end(), rest.begin(), rest.end());
    return triangles;
  }

 private:
  const Vec3d& at(std::size_t corner) const { return vertices_[static_cast<std::size_t>(corners_[corner])]; }
  Vec3d doubled_area(std::size_t a, std::size_t b, std::size_t c) const { return cross(at(b) - at(a), at(c) - at(a)); }
  /// Share of the polygon's area that a doubled area has, seen along the polygon's normal.
  double seen(const Vec3d& area) const { return dot(area, whole_) / squared_norm(whole_); }

  bool is_ear(const std::vector<std::size_t>& rest, std::size_t a, std::size_t b, std::size_t c) const {
    if (seen(doubled_area(a, b, c)) < -rounding) return false;
    return std::none_of(rest.begin(), rest.end(), [&](std::size_t p) {
      const auto is_corner = [&](std::size_t k) { return corners_[p] == corners_[k]; };
      if (is_corner(a) || is_corner(b) || is_corner(c)) return false;
      return seen(doubled_area(a, b, p)) > -rounding && seen(doubled_area(b, c, p)) > -rounding && seen(doubled_area(c, a, p)) > -rounding;
    });
  }

  const std::vector<Vec3d>& vertices_;
  std::span<const int> corners_;
  Vec3d whole_{};
};

}  // namespace

bool add_polygon(Panels& out, std::span<const int> corners) {
  constexpr std::size_t most_with_ears = 500;
  if (corners.size() < 3) return false;
  if (corners.size() == 3) return out.add_triangle(corners[0], corners[1], corners[2]), true;
  if (corners.size() == 4) return out.add_quad(corners[0], corners[1], corners[2], corners[3]), true;
  const Polygon polygon(out.vertices, corners);
  if (polygon.is_fan()) {
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) out.add_triangle(corners[0], corners[k], corners[k + 1]);
    return true;
  }
  if (corners.size() > most_with_ears || !polygon.has_area()) return false;
  const std::vector<std::size_t> ears = polygon.ears();
  if (ears.size() != 3 * (corners.size() - 2)) return false;
  for (std::size_t k = 0; k < ears.size(); k += 3) out.add_triangle(corners[ears[k]], corners[ears[k + 1]], corners[ears[k + 2]]);
  return true;
}

}  // namespace fccda
