#include "fccda/deforming/moving_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fccda {

namespace {

constexpr std::array<Feature, 3> edges{Feature::edge_0, Feature::edge_1, Feature::edge_2};
constexpr double unit = 0.5 * std::numeric_limits<double>::epsilon();  // 2⁻⁵³

Vec3d magnitudes(const Vec3d& a) { return {std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}; }
double largest_of(const Vec3d& a, const Vec3d& b) { return std::max(largest_magnitude(a), largest_magnitude(b)); }

/// s(t) in Bernstein form, and the bound of its error.
class Volume {
 public:
  Volume(const Path& point, const MovingTriangle& triangle) {
    const Corners &s = triangle.t0, &t = triangle.t1;
    const Vec3d d0 = point.start - s.a, d1 = point.end - t.a, e0 = s.b - s.a, e1 = t.b - t.a, f0 = s.c - s.a, f1 = t.c - t.a;
    const Vec3d n0 = cross(e0, f0), between = cross(e0, f1) + cross(e1, f0), n1 = cross(e1, f1);
    value_ = {dot(d0, n0), (dot(d1, n0) + dot(d0, between)) / 3, (dot(d1, between) + dot(d0, n1)) / 3, dot(d1, n1)};
    // A coefficient is the mean of at most six times six products, each with at most eleven roundings: 66 u. Its evaluation adds 48 u, and the
    // rounding of the extrema's times less than u.
    error_ = 256 * unit * largest_of(d0, d1) * largest_of(e0, e1) * largest_of(f0, f1);
  }

  double operator()(double t) const {
    const double r = 1 - t;
    return r * r * (r * value_[0] + 3 * t * value_[1]) + t * t * (3 * r * value_[2] + t * value_[3]);
  }
  bool is_front(double value) const { return value > error_; }    // certainly
  bool is_behind(double value) const { return value < -error_; }  // certainly

  /// It is between the least and the largest coefficient throughout.
  bool may_cross() const {
    return is_behind(*std::min_element(value_.begin(), value_.end())) && (!is_behind(value_[0]) || is_front(*std::max_element(value_.begin(), value_.end())));
  }

  /// The ends of the parts in which it is monotone, up to far less than its error.
  struct Parts {
    std::array<double, 4> end{0, 1, 1, 1};
    std::size_t count = 1;
  };
  Parts monotone_parts() const {
    const double p = value_[1] - value_[0], q = value_[2] - value_[1], r = value_[3] - value_[2];  // the slope in Bernstein form, over 3
    const double a = p - 2 * q + r, b = q - p, square = q * q - p * r;
    Parts parts;
    if (!(square > 0)) return parts;
    const double sum = -(b + std::copysign(std::sqrt(square), b));
    std::array<double, 2> roots{sum / a, p / sum};
    if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
    parts.count = 0;
    for (const double root : roots)
      if (root > 0 && root < 1) parts.end[++parts.count] = root;
    parts.end[++parts.count] = 1;
    return parts;
  }

 private:
  std::array<double, 4> value_;
  double error_;
};

/// An interval of time.
struct Span {
  double begin, end;
  double middle() const { return 0.5 * (begin + end); }
};

/// Shrinks an interval at whose begin `is_early`, and at whose end not, to neighbouring numbers.
template <class IsEarly>
Span bisected(Span span, const IsEarly& is_early) {
  for (;;) {
    const double middle = span.middle();
    if (!(middle > span.begin && middle < span.end)) return span;
    (is_early(middle) ? span.begin : span.end) = middle;
  }
}

/// Where the volume falls from certainly positive at the begin of a part (or undetermined from `begin` on) to certainly negative at its end.
Span fall(const Volume& volume, Span part) {
  // A root to rounding by false position (the Illinois variant), then outward until both signs are certain.
  Span span = part;
  double low = volume(part.begin), high = volume(part.end);
  if (volume.is_front(low)) {
    double root = part.begin;
    int side = 0;
    for (int step = 0; step < 64 && span.end - span.begin > 2 * unit; ++step) {
      const double next = (low * span.end - high * span.begin) / (low - high);
      if (!(next > span.begin && next < span.end)) break;
      const double value = volume(next);
      root = next;
      if (!volume.is_front(value) && !volume.is_behind(value)) break;
      const int now = value > 0 ? 1 : -1;
      if (value > 0)
        span.begin = next, low = value, high *= side == now ? 0.5 : 1;
      else
        span.end = next, high = value, low *= side == now ? 0.5 : 1;
      side = now;
    }
    span = part;
    for (double width = 4 * unit; width < 1; width *= 4) {
      const double begin = root - width, end = root + width;
      if (begin > span.begin && volume.is_front(volume(begin))) span.begin = begin;
      if (end < span.end && volume.is_behind(volume(end))) span.end = end;
      if (span.begin >= begin && span.end <= end) return span;
    }
    return span;
  }
  return {part.begin, bisected(part, [&](double t) { return !volume.is_behind(volume(t)); }).end};
}

/// The corners as seen from a moving point. Their differences are formed at both ends, so that what all have in common cancels.
class Around {
 public:
  Around(const Path& point, const MovingTriangle& triangle)
      : corners_{{triangle.t0.a - point.start, triangle.t0.b - point.start, triangle.t0.c - point.start},
                 {triangle.t1.a - point.end, triangle.t1.b - point.end, triangle.t1.c - point.end}} {
    const Corners &s = corners_.t0, &t = corners_.t1;
    speed_ = std::sqrt(std::max({squared_norm(t.a - s.a), squared_norm(t.b - s.b), squared_norm(t.c - s.c)}));
    size_ = largest_magnitude(max(max(max(magnitudes(s.a), magnitudes(s.b)), magnitudes(s.c)), max(max(magnitudes(t.a), magnitudes(t.b)), magnitudes(t.c))));
  }

  Corners at(double fraction) const { return corners_.at(fraction); }
  double distance(double fraction) const { return norm(closest_on_triangle({}, corners_.at(fraction)).point); }
  double speed() const { return speed_; }                // largest, of a corner relative to the point, per step
  double rounding() const { return 64 * unit * size_; }  // of distances

  /// The relative velocity of the corners per step.
  Corners rates() const {
    const Corners &s = corners_.t0, &t = corners_.t1;
    return {t.a - s.a, t.b - s.b, t.c - s.c};
  }

 private:
  MovingTriangle corners_;
  double speed_, size_;
};

/// The first time in the span at which the point may be on the triangle, found by halving until the drift of a half is below `least` [m].
std::optional<double> meeting(const Around& around, const Span& span, double least) {
  const double middle = span.middle(), drift = 0.5 * (span.end - span.begin) * around.speed();
  if (around.distance(middle) > around.rounding() + drift) return std::nullopt;
  if (!(drift > least) || !(middle > span.begin && middle < span.end)) return middle;
  const std::optional<double> first = meeting(around, {span.begin, middle}, least);
  return first ? first : meeting(around, {middle, span.end}, least);
}

/// The same to rounding, or to a thousandth of a span in which the point moves in the plane of the triangle.
std::optional<double> meeting(const Around& around, const Span& span) {
  return meeting(around, span, std::max(4 * around.rounding(), 0x1p-11 * (span.end - span.begin) * around.speed()));
}

/// How long all corners stay farther than the radius from the origin, in front of a plane through it with the normal `towards` + t `turning`. `turning` is
/// perpendicular to `towards`, a unit vector. Where the corners are farther than that from the plane, so is the triangle from the origin.
double time_of_plane(const Corners& corners, const Corners& rates, const Vec3d& towards, const Vec3d& turning, double radius) {
  double time = std::numeric_limits<double>::infinity();
  const auto limit = [&](const Vec3d& corner, const Vec3d& rate) {
    // The height, over radius times a bound of the normal's length, sqrt(1 + t² turning²): a + b t + c t².
    const double a = std::max(0.0, dot(towards, corner) - radius), b = dot(towards, rate) + dot(turning, corner);
    const double c = dot(turning, rate) - 0.5 * radius * squared_norm(turning);
    const double square = b * b - 4 * a * c;
    if (!(square >= 0) || (b >= 0 && c >= 0)) return;
    const double sum = -0.5 * (b + std::copysign(std::sqrt(square), b));
    time = std::min(time, b < 0 ? a / sum : sum / c);
  };
  limit(corners.a, rates.a), limit(corners.b, rates.b), limit(corners.c, rates.c);
  return time;
}

/// How planes turn that follow the face, and the edge if that is closest: then their corners keep equal heights.
std::array<Vec3d, 2> turnings(const Corners& corners, const Corners& rates, const Vec3d& towards, Feature feature) {
  const std::array<Vec3d, 3> x{corners.a, corners.b, corners.c};
  const std::array<double, 3> rising{dot(towards, rates.a), dot(towards, rates.b), dot(towards, rates.c)};
  const auto perpendicular = [&](const Vec3d& turning) { return is_finite(turning) ? turning - dot(turning, towards) * towards : Vec3d{}; };
  const Vec3d area = cross(x[1] - x[0], x[2] - x[0]);
  Vec3d with_face{}, with_edge{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d edge = x[(k + 1) % 3] - x[k];
    with_face -= rising[(k + 2) % 3] / squared_norm(area) * cross(area, edge);
    if (feature == edges[k]) with_edge = (rising[k] - rising[(k + 1) % 3]) / squared_norm(edge) * edge;
  }
  return {perpendicular(with_face), perpendicular(with_edge)};
}

}  // namespace

std::optional<double> front_crossing(const Path& point, const MovingTriangle& triangle) {
  const Volume volume(point, triangle);
  if (!volume.may_cross()) return std::nullopt;
  const Around around(point, triangle);
  const Volume::Parts parts = volume.monotone_parts();
  bool in_front = !volume.is_behind(volume(0));
  double last_front = 0;
  for (std::size_t k = 0; k < parts.count; ++k) {
    const Span part{parts.end[k], parts.end[k + 1]};
    if (volume.is_front(volume(part.begin))) last_front = part.begin;
    const double after = volume(part.end);
    if (volume.is_front(after)) in_front = true, last_front = part.end;
    if (!in_front || !volume.is_behind(after)) continue;
    Span crossing = fall(volume, part);
    if (last_front < part.begin) crossing.begin = last_front;
    if (const std::optional<double> time = meeting(around, crossing)) return time;
    in_front = false;
  }
  return std::nullopt;
}

std::array<double, 3> barycentric(const Corners& triangle, const Vec3d& point) {
  const PointOnTriangle on = closest_on_triangle(point, triangle);
  const auto share = [&](const Vec3d& from, const Vec3d& to) { return std::clamp(dot(on.point - from, to - from) / squared_norm(to - from), 0.0, 1.0); };
  switch (on.feature) {
    case Feature::vertex_0:
      return {1, 0, 0};
    case Feature::vertex_1:
      return {0, 1, 0};
    case Feature::vertex_2:
      return {0, 0, 1};
    case Feature::edge_0: {
      const double s = share(triangle.a, triangle.b);
      return {1 - s, s, 0};
    }
    case Feature::edge_1: {
      const double s = share(triangle.b, triangle.c);
      return {0, 1 - s, s};
    }
    case Feature::edge_2: {
      const double s = share(triangle.c, triangle.a);
      return {s, 0, 1 - s};
    }
    case Feature::face:
      break;
  }
  const Vec3d normal = cross(triangle.b - triangle.a, triangle.c - triangle.a), from_a = on.point - triangle.a;
  const double square = squared_norm(normal);
  const double v = std::clamp(dot(cross(from_a, triangle.c - triangle.a), normal) / square, 0.0, 1.0);
  const double w = std::clamp(dot(cross(triangle.b - triangle.a, from_a), normal) / square, 0.0, 1 - v);
  return {1 - v - w, v, w};
}

std::optional<double> first_contact(const Path& centre, const MovingTriangle& triangle, double radius, double tolerance, double until) {
  constexpr int max_steps = 200;   // at grazing contact each step halves the remainder
  constexpr int plain_steps = 8;   // most contacts are decided by then
  constexpr double along = 1e-14;  // a slope within rounding: a path along the triangle, not towards it
  const Around around(centre, triangle);
  const Corners rates = around.rates();
  double fraction = 0;
  for (int step = 0; step < max_steps; ++step) {
    const Corners corners = around.at(fraction);
    const PointOnTriangle on = closest_on_triangle({}, corners);
    const double distance = norm(on.point);
    if (distance == 0) return fraction;
    const Vec3d towards = on.feature == Feature::face ? std::copysign(1.0, dot(on.point, cross(corners.b - corners.a, corners.c - corners.a))) *
                                                            normalised(cross(corners.b - corners.a, corners.c - corners.a))
                                                      : on.point / distance;
    if (distance - radius <= tolerance) {
      if (fraction > 0) return fraction;
      const std::array<double, 3> weights = barycentric(corners, {});
      const double rate = dot(towards, weights[0] * rates.a + weights[1] * rates.b + weights[2] * rates.c);
      if (rate < -along * around.speed()) return fraction;
      radius = std::min(radius, distance - 2 * tolerance);
      if (!(radius > 0)) return std::nullopt;
    }
    double next = fraction + time_of_plane(corners, rates, towards, {}, radius);
    if (step >= plain_steps && radius > 0)  // it comes along with a triangle that turns
      for (const Vec3d& turning : turnings(corners, rates, towards, on.feature))
        next = std::max(next, fraction + time_of_plane(corners, rates, towards, turning, radius));
    if (!(next <= until)) return std::nullopt;
    if (next == fraction) return fraction;
    fraction = next;
  }
  return fraction;
}

}  // namespace fccda
