#include "perimpact/discretisation/crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace perimpact {

using fccda::InputError;

namespace {

using Point = std::array<double, 2>;

/// Twice the signed area of the triangle abc, positive if anticlockwise.
double turn(const Point& a, const Point& b, const Point& c) { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); }

double distance_to_side(const Point& p, const Point& a, const Point& b) {
  const double x = b[0] - a[0], y = b[1] - a[1];
  const double share = std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y), 0.0, 1.0);
  return std::hypot(p[0] - a[0] - share * x, p[1] - a[1] - share * y);
}

/// True if the segments ab and cd intersect or are closer than `least`.
bool meet(const Point& a, const Point& b, const Point& c, const Point& d, double least) {
  const bool cross = (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
  return cross || std::min({distance_to_side(a, c, d), distance_to_side(b, c, d), distance_to_side(c, a, b), distance_to_side(d, a, b)}) <= least;
}

/// Newell's method: twice the area vector of the polygon.
Vec3d area_vector(const std::vector<Vec3d>& polygon) {
  Vec3d sum{};
  for (std::size_t k = 0; k < polygon.size(); ++k) sum += cross(polygon[k] - polygon[0], polygon[(k + 1) % polygon.size()] - polygon[0]);
  return sum;
}

/// [m] largest distance of a corner from the first, the reference length of tolerances.
double size_of(const std::vector<Vec3d>& polygon) {
  double size = 0;
  for (const Vec3d& corner : polygon) size = std::max(size, norm(corner - polygon[0]));
  return size;
}

}  // namespace

Crack::Crack(const std::vector<Vec3d>& polygon, double tolerance) : tolerance_(tolerance) {
  if (polygon.size() < 3)
    throw InputError(
        fmt::format("the crack has {} corners, but a polygon needs at least three (a line of two is for plane bodies only); give them in order around it.",
                    polygon.size()));
  const double size = size_of(polygon);
  const Vec3d area = area_vector(polygon);
  constexpr double least_area = 1e-6;  // of the size squared: below this the plane depends on rounding
  if (!(norm(area) > least_area * size * size)) throw InputError("the crack's corners are collinear, so it has no area; move one of them.");
  axes_[2] = normalised(area);
  for (const Vec3d& corner : polygon) origin_ += corner / static_cast<double>(polygon.size());
  constexpr double flat = 1e-3;  // of the size: permits truncated digits
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (const double off = std::fabs(height(polygon[k])); off > flat * size)
      throw InputError(
          fmt::format("corner {} of the crack lies {:.3g} m off the plane of the others, but a crack is plane; move it, or use two cracks.", k + 1, off));
  const Vec3d along = polygon[1] - polygon[0];
  axes_[0] = normalised(along - dot(along, axes_[2]) * axes_[2]);
  axes_[1] = cross(axes_[2], axes_[0]);
  for (const Vec3d& corner : polygon) corners_.push_back(in_plane(corner));
  expect_simple();
}

Crack Crack::through_thickness(const Vec3d& a, const Vec3d& b, double tolerance) {
  if (a == b) throw InputError("both ends of the crack coincide; move one of them.");
  const Vec3d up{0, 0, norm(b - a)};  // any height: the body is one layer
  return Crack({a - up, b - up, b + up, a + up}, tolerance);
}

void Crack::expect_simple() const {
  const std::size_t n = corners_.size();
  const auto corner = [&](std::size_t k) -> const Point& { return corners_[k % n]; };
  for (std::size_t k = 0; k < n; ++k)
    if (std::hypot(corner(k + 1)[0] - corner(k)[0], corner(k + 1)[1] - corner(k)[1]) <= tolerance_)
      throw InputError(fmt::format("corners {} and {} of the crack coincide; remove one.", k + 1, (k + 1) % n + 1));
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t m = k + 2; m < n; ++m) {
      if ((m + 1) % n == k) continue;  // neighbours share a corner
      if (meet(corner(k), corner(k + 1), corner(m), corner(m + 1), tolerance_))
        throw InputError(
            fmt::format("the side after corner {} of the crack intersects the one after corner {}; give the corners in order around it.", k + 1, m + 1));
    }
  }
}

bool Crack::is_in_polygon(const Vec3d& point) const {
  const Point p = in_plane(point);
  bool inside = false;
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const Point &a = corners_[k], &b = corners_[(k + 1) % corners_.size()];
    if (distance_to_side(p, a, b) <= tolerance_) return true;
    if ((a[1] > p[1]) != (b[1] > p[1])) inside ^= (turn(a, b, p) > 0) == (b[1] > a[1]);
  }
  return inside;
}

bool Crack::cuts(const Vec3d& one, const Vec3d& other) const {
  const double h_one = height(one), h_other = height(other);
  const bool is_above = h_one >= -tolerance_;
  if (is_above == (h_other >= -tolerance_)) return false;
  // always from above to below, so that both ends of a bond give the same result
  const Vec3d &top = is_above ? one : other, &bottom = is_above ? other : one;
  const double h_top = is_above ? h_one : h_other, h_bottom = is_above ? h_other : h_one;
  return is_in_polygon(top + std::max(0.0, h_top / (h_top - h_bottom)) * (bottom - top));
}

}  // namespace perimpact
