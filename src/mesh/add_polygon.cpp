#include "mesh/add_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace fccda {
namespace {

constexpr double rounding = 1e-12;  // of collinear corners, relative

class Polygon {
 public:
  Polygon(const std::vector<Vec3d>& vertices, std::span<const int> corners) : vertices_(vertices), corners_(corners) {
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) whole_ += doubled_area(0, k, k + 1);
  }

  /// True if all triangles of the fan from the first corner have the same sense and none overlap.
  bool is_fan() const {
    for (std::size_t k = 1; k + 1 < corners_.size(); ++k) {
      const Vec3d area = doubled_area(0, k, k + 1);
      if (whole_ == Vec3d{} ? area != Vec3d{} : seen(area) < -rounding) return false;
    }
    return !has_area() || turns_once();
  }

  bool has_area() const { return whole_ != Vec3d{}; }

  /// True if two sides intersect in their interiors. The cost is quadratic in the number of corners.
  bool has_crossing() const {
    const std::size_t count = corners_.size();
    const auto side_of = [&](std::size_t a, std::size_t c) { return seen(doubled_area(a, (a + 1) % count, c % count)); };  // of the line through side a
    const auto are_apart = [](double one, double other) { return std::min(one, other) < -rounding && std::max(one, other) > rounding; };
    for (std::size_t a = 0; a + 2 < count; ++a) {
      double here = side_of(a, a + 2), next = 0;
      for (std::size_t c = a + 2; c < count; ++c, here = next) {
        next = side_of(a, c + 1);
        if (are_apart(here, next) && are_apart(side_of(c, a), side_of(c, a + 1))) return true;
      }
    }
    return false;
  }

  /// Ear clipping. Corner numbers, three per triangle; incomplete if no ear is left. Sides must not cross.
  std::vector<std::size_t> ears() {
    std::vector<std::size_t> rest(corners_.size()), triangles;
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = k;
    for (std::size_t k = 0; k < rest.size(); ++k) is_convex_.push_back(is_convex_at(rest, k));
    for (std::size_t since_last = 0, k = 0; rest.size() > 3 && since_last < rest.size();) {
      const std::size_t before = rest[(k + rest.size() - 1) % rest.size()], here = rest[k], after = rest[(k + 1) % rest.size()];
      if (is_ear(rest, before, here, after)) {
        triangles.insert(triangles.end(), {before, here, after});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
        since_last = 0;
        k %= rest.size();
        for (const std::size_t beside : {k, (k + rest.size() - 1) % rest.size()}) is_convex_[rest[beside]] = is_convex_at(rest, beside);
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
  /// The doubled area projected onto the polygon's normal, as a fraction of the polygon's area.
  double seen(const Vec3d& area) const { return dot(area, whole_) / squared_norm(whole_); }

  /// True if the directions from the first corner turn by at most one full turn. Otherwise triangles of the same sense overlap, as on a
  /// spiral staircase.
  bool turns_once() const {
    constexpr double margin = 1e-6;  // [rad] for the accumulated rounding of as many angles as an int counts
    const Vec3d normal = normalised(whole_);
    double turned = 0;
    Vec3d last{};
    for (std::size_t k = 1; k < corners_.size(); ++k) {
      const Vec3d sight = at(k) - at(0), direction = sight - dot(sight, normal) * normal;
      if (direction == Vec3d{}) continue;  // the outline returns to its first corner, and may continue in any direction
      const Vec3d area = cross(last, direction);
      const bool is_backwards = seen(area) < -rounding;
      turned += std::atan2(is_backwards ? dot(area, normal) : std::max(dot(area, normal), 0.0), dot(last, direction));
      if (is_backwards) turned += 2 * std::numbers::pi;
      last = direction;
    }
    return !(turned > 2 * std::numbers::pi + margin);
  }

  /// True if the k-th remaining corner is neither re-entrant nor straight.
  bool is_convex_at(const std::vector<std::size_t>& rest, std::size_t k) const {
    return seen(doubled_area(rest[(k + rest.size() - 1) % rest.size()], rest[k], rest[(k + 1) % rest.size()])) > rounding;
  }

  /// Of the corners inside a triangle, the one farthest from its side a c has nothing but the polygon beyond it towards b. So it is
  /// re-entrant or straight, and only such corners need to be tested.
  bool is_ear(const std::vector<std::size_t>& rest, std::size_t a, std::size_t b, std::size_t c) const {
    if (seen(doubled_area(a, b, c)) < -rounding) return false;
    return std::none_of(rest.begin(), rest.end(), [&](std::size_t p) {
      if (is_convex_[p]) return false;
      const auto is_corner = [&](std::size_t k) { return corners_[p] == corners_[k]; };
      if (is_corner(a) || is_corner(b) || is_corner(c)) return false;
      return seen(doubled_area(a, b, p)) > -rounding && seen(doubled_area(b, c, p)) > -rounding && seen(doubled_area(c, a, p)) > -rounding;
    });
  }

  const std::vector<Vec3d>& vertices_;
  std::span<const int> corners_;
  Vec3d whole_{};
  std::vector<bool> is_convex_;  // by corner, among those remaining
};

}  // namespace

bool add_polygon(Panels& out, std::span<const int> corners) {
  constexpr std::size_t most_with_ears = 500;
  if (corners.size() < 3) return false;
  if (corners.size() == 3) return out.add_triangle(corners[0], corners[1], corners[2]), true;
  if (corners.size() == 4) return out.add_quad(corners[0], corners[1], corners[2], corners[3]), true;
  Polygon polygon(out.vertices, corners);
  if (polygon.is_fan()) {
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) out.add_triangle(corners[0], corners[k], corners[k + 1]);
    return true;
  }
  if (corners.size() > most_with_ears || !polygon.has_area() || polygon.has_crossing()) return false;
  const std::vector<std::size_t> ears = polygon.ears();
  if (ears.size() != 3 * (corners.size() - 2)) return false;
  for (std::size_t k = 0; k < ears.size(); k += 3) out.add_triangle(corners[ears[k]], corners[ears[k + 1]], corners[ears[k + 2]]);
  return true;
}

}  // namespace fccda
