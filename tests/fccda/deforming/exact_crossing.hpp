/// Reference solution for the crossing of a moving triangle by a moving point, in numbers of 113 binary digits. It shares nothing with the library but
/// Vec3 and the structs of its input.
///
/// Decisions are exact where coordinates are small integers. There the volume s(t) has integer coefficients, and so have the weights q(t) of the corners
/// (polynomials of degree 4). If q does not vanish at a root of s, then |q| >= |lc(s)|^-4 Π|q(other roots)|^-1 there, by their resultant: above 1e-22
/// for coordinates up to 3, while the rounding error is below 1e-26. For larger coordinates the same threshold is a margin of 1e-22, which random ones
/// never fall below by chance.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "fccda/deforming/moving_triangle.hpp"

namespace exact {

__extension__ typedef __float128 Wide;

inline Wide magnitude(Wide x) { return x < 0 ? -x : x; }

inline Wide root(Wide square) {
  Wide x = std::sqrt(static_cast<double>(square));
  if (x == 0) return 0;
  for (int k = 0; k < 3; ++k) x = (x + square / x) / 2;
  return x;
}

struct Place {
  Wide x, y, z;
  friend Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Place operator*(Wide s, const Place& a) { return {s * a.x, s * a.y, s * a.z}; }
};

inline Place wide(const fccda::Vec3d& a) { return {a.x, a.y, a.z}; }
inline Wide dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Place cross(const Place& a, const Place& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

/// a + t b
struct Line {
  Place a, b;
  Line(const fccda::Vec3d& from, const fccda::Vec3d& to) : a(wide(from)), b(wide(to) - wide(from)) {}
  Line(const Place& at, const Place& rate) : a(at), b(rate) {}
  Place at(Wide t) const { return a + t * b; }
  friend Line operator-(const Line& p, const Line& q) { return {p.a - q.a, p.b - q.b}; }
};

struct Answer {
  bool crosses = false;
  double time = 0;
  double margin = 1;  ///< the least |weight| of a corner, of all roots that were decided: how clear the decision is
};

/// The first crossing from the front: s = 0, s > 0 before (or this is the start), s < 0 after, and the point in the closed triangle.
inline Answer front_crossing(const fccda::Path& path, const fccda::MovingTriangle& triangle) {
  const Line p(path.start, path.end), a(triangle.t0.a, triangle.t1.a), b(triangle.t0.b, triangle.t1.b), c(triangle.t0.c, triangle.t1.c);
  const Line d = p - a, e = b - a, f = c - a;
  const Place n0 = cross(e.a, f.a), n1 = cross(e.a, f.b) + cross(e.b, f.a), n2 = cross(e.b, f.b);
  const std::array<Wide, 4> s{dot(d.a, n0), dot(d.b, n0) + dot(d.a, n1), dot(d.b, n1) + dot(d.a, n2), dot(d.b, n2)};
  const Wide tiny = 1e-29 * (magnitude(s[0]) + magnitude(s[1]) + magnitude(s[2]) + magnitude(s[3]));
  const auto value = [&](Wide t) { return s[0] + t * (s[1] + t * (s[2] + t * s[3])); };
  const auto volume = [&](Wide t) { return magnitude(value(t)) <= tiny ? Wide(0) : value(t); };

  std::vector<Wide> ends{0};
  const Wide square = s[2] * s[2] - 3 * s[3] * s[1];
  if (square > 0) {
    const Wide sum = -(s[2] + (s[2] < 0 ? -root(square) : root(square)));
    Wide first = s[3] != 0 ? sum / (3 * s[3]) : Wide(-1), second = sum != 0 ? s[1] / sum : Wide(-1);
    if (first > second) std::swap(first, second);
    for (const Wide end : {first, second})
      if (end > 0 && end < 1) ends.push_back(end);
  }
  ends.push_back(1);

  Answer answer;
  const auto in_triangle = [&](Wide t) {
    const Place pa = a.at(t) - p.at(t), pb = b.at(t) - p.at(t), pc = c.at(t) - p.at(t), normal = cross(pb - pa, pc - pa);
    const Wide area = dot(normal, normal), longest = dot(pb - pa, pb - pa) + dot(pc - pa, pc - pa);
    if (area <= 1e-22 * longest * longest) {  // collapsed: on one of its sides
      answer.margin = 0;
      for (const auto& [u, v] : {std::pair(pa, pb), std::pair(pb, pc), std::pair(pc, pa)}) {
        const Place across = cross(u, v), along = v - u;
        if (dot(along, along) > 1e-40 * longest && dot(across, across) <= 1e-40 * longest * longest && dot(u, along) <= 0 && dot(v, along) >= 0) return true;
      }
      return dot(pa, pa) <= 1e-40;  // or shrunk to a point
    }
    bool inside = true;
    for (const Place& across : {cross(pb, pc), cross(pc, pa), cross(pa, pb)}) {
      const Wide weight = dot(normal, across) / area;
      answer.margin = std::min(answer.margin, std::fabs(static_cast<double>(weight)));
      inside &= weight >= -1e-22;
    }
    return inside;
  };
  bool front = volume(0) >= 0;
  Wide last_zero = 0;  // where s is 0 up to the present part
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    Wide low = ends[k], high = ends[k + 1];
    const Wide before = volume(low), after = volume(high);
    if (before == 0) last_zero = low;
    if (after > 0) front = true;
    if (!front || !(after < 0)) continue;
    Wide time = last_zero;
    if (before > 0) {
      for (int step = 0; step < 112; ++step) {
        const Wide middle = (low + high) / 2;
        (value(middle) > 0 ? low : high) = middle;
      }
      time = (low + high) / 2;
      // A triple root, which halving finds to a third of the digits only.
      if (s[3] != 0 && volume(-s[2] / (3 * s[3])) == 0 && square == 0) time = -s[2] / (3 * s[3]);
    }
    front = false;
    if (!in_triangle(time)) continue;
    answer.crosses = true;
    answer.time = static_cast<double>(time);
    return answer;
  }
  return answer;
}

}  // namespace exact
