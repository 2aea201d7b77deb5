/// An infinite sector of the plane with its tip at the origin.
#pragma once

#include <algorithm>
#include <cmath>

namespace fccda {

/// A point of the cross-section of a cylinder.
struct Flat {
  double x, y;  ///< [m]
};

/// Scalar product [m²].
inline double dot(const Flat& a, const Flat& b) { return a.x * b.x + a.y * b.y; }
/// Distance from the origin [m].
inline double norm(const Flat& a) { return std::sqrt(dot(a, a)); }

/// Convex: less than half a turn wide.
class Wedge {
 public:
  /// From the angle `start`, `opening` wide [rad].
  Wedge(double start, double opening)
      : first_(at(start)),
        last_(at(start + opening)),
        middle_(at(start + 0.5 * opening)),
        from_first_{-first_.y, first_.x},  // normals of its two edges, inward
        from_last_{last_.y, -last_.x} {}

  /// True inside the wedge widened by the margin [m].
  bool contains(const Flat& p, double margin) const { return dot(p, from_first_) >= -margin && dot(p, from_last_) >= -margin && dot(p, middle_) >= -margin; }

  /// True if a line along one of its edges or across its tip separates the wedge, widened by the margin, from both points.
  bool is_parted_from(const Flat& a, const Flat& b, double margin) const {
    const auto parts = [&](const Flat& normal) { return dot(a, normal) < -margin && dot(b, normal) < -margin; };
    return parts(from_first_) || parts(from_last_) || parts(middle_);
  }

  /// [m], 0 inside
  double distance(const Flat& p) const {
    if (contains(p, 0)) return 0;
    return std::min(from_ray(p, first_), from_ray(p, last_));
  }

 private:
  static Flat at(double angle) { return {std::cos(angle), std::sin(angle)}; }
  static double from_ray(const Flat& p, const Flat& ray) {
    const double along = dot(p, ray);
    return along > 0 ? std::fabs(p.x * ray.y - p.y * ray.x) : norm(p);
  }

  Flat first_, last_, middle_;   // unit
  Flat from_first_, from_last_;  // unit
};

}  // namespace fccda
