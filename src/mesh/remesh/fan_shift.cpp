#include "mesh/remesh/fan_shift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/contract.hpp"

namespace fccda {
namespace {

constexpr double least_facing = 0.05;  // cosine of 87°: the distance along the direction is 20 times that across the triangle there

/// A point relative to the centre: x and y across the direction, height along it.
struct Projected {
  double x, y, height;
};

double area(const Projected& a, const Projected& b) { return a.x * b.y - a.y * b.x; }
Projected operator-(const Projected& a, const Projected& b) { return {a.x - b.x, a.y - b.y, a.height - b.height}; }

/// True if the triangle of two vectors from its first corner faces the direction.
bool faces(const Projected& u, const Projected& v) {
  const double projected = area(u, v), sideways = std::hypot(u.y * v.height - u.height * v.y, u.height * v.x - u.x * v.height);
  return projected > 0 && projected * projected * (1 - least_facing * least_facing) > least_facing * least_facing * sideways * sideways;
}

class Overlay {
 public:
  Overlay(const Fan& fan, std::size_t to, const Vec3d& direction) : count_(fan.link.size()), triangles_(fan.size()), to_(to) {
    // the first link on the x axis, so that a closed fan crosses it once, and one at a boundary never again
    const Vec3d first = fan.link[0] - fan.centre;
    const Vec3d x = normalised(first - dot(first, direction) * direction), y = cross(direction, x);
    for (std::size_t j = 0; j < count_; ++j) {
      const Vec3d p = fan.link[j] - fan.centre;
      link_[j] = {dot(p, x), dot(p, y), dot(p, direction)};
    }
    link_[0].y = 0;
  }

  /// Both triangulations cover the polygon exactly once: all triangles face the direction, and the fan makes one revolution.
  bool is_one_to_one() const {
    std::size_t revolutions = 0;  // crossings from below the x axis to above
    for (std::size_t j = 0; j < triangles_; ++j) {
      if (!faces(link_[j], next(j))) return false;
      if (!touches_target(j) && !faces(link_[j] - link_[to_], next(j) - link_[to_])) return false;
      revolutions += link_[j].y < 0 && next(j).y >= 0;
    }
    return triangles_ == count_ ? revolutions == 1 : revolutions == 0;
  }

  double largest_difference() const {
    double largest = std::fabs(height_at_centre());
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = 0; j < count_; ++j)
        if (i != j && i != to_ && j != to_) largest = std::max(largest, difference_at_crossing(i, j));
    return largest;
  }

 private:
  const Projected& next(std::size_t j) const { return link_[j + 1 < count_ ? j + 1 : 0]; }
  bool touches_target(std::size_t j) const { return j == to_ || (j + 1 < count_ ? j + 1 : 0) == to_; }

  /// Height of the new triangles at the centre, in the triangle in which it lies deepest.
  double height_at_centre() const {
    double deepest = -std::numeric_limits<double>::infinity(), height = 0;
    const Projected& a = link_[to_];
    for (std::size_t j = 0; j < triangles_; ++j) {
      if (touches_target(j)) continue;
      const Projected &b = link_[j], &c = next(j);
      const double at_a = area(b, c), at_b = area(c, a), at_c = area(a, b), whole = at_a + at_b + at_c;
      const double depth = std::min({at_a, at_b, at_c}) / whole;
      if (depth > deepest) deepest = depth, height = (at_a * a.height + at_b * b.height + at_c * c.height) / whole;
    }
    return height;
  }

  /// Difference of heights where the old edge from the centre to link i crosses the new one from the target to link j; 0 if they do not cross.
  double difference_at_crossing(std::size_t i, std::size_t j) const {
    const Projected& a = link_[to_];
    const Projected along = link_[j] - a;
    const double determinant = area(link_[i], along);
    if (determinant == 0) return 0;
    const double on_old = area(a, along) / determinant, on_new = area(a, link_[i]) / determinant;
    constexpr double rounding = 1e-9;  // this little beyond an end, the difference is that at the end
    if (on_old < -rounding || on_old > 1 + rounding || on_new < -rounding || on_new > 1 + rounding) return 0;
    return std::fabs(on_old * link_[i].height - (a.height + on_new * along.height));
  }

  std::size_t count_, triangles_, to_;
  std::array<Projected, Fan::max_links> link_;
};

}  // namespace

std::optional<double> shift(const Fan& fan, std::size_t to, const Vec3d& direction) {
  EXPECTS(fan.link.size() <= Fan::max_links && fan.size() >= 2 && to < fan.link.size());
  const Overlay overlay(fan, to, direction);
  if (!overlay.is_one_to_one()) return std::nullopt;
  return overlay.largest_difference();
}

}  // namespace fccda
