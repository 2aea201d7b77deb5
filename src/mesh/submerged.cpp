#include "mesh/submerged.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/contract.hpp"
#include "base/parallel.hpp"

namespace fccda {

namespace {

/// A corner of a triangle relative to a point of the plane, and its depth.
struct Wet {
  Vec3d p;
  double s;
};

struct WetSum {
  double volume = 0;      // [m³]
  Vec3d first{};          // [m⁴] ∫ p dV
  double waterplane = 0;  // [m²]
};

/// With corners a, b, c of area A: ∫ f dA = A Σf/3 and ∫ f g dA = A (Σ f_i g_i + Σf Σg)/12 for f and g that are linear.
void add_wet_triangle(WetSum& sum, const Wet& a, const Wet& b, const Wet& c, const Vec3d& up) {
  const double projected = 0.5 * dot(up, cross(b.p - a.p, c.p - a.p));  // n·u A
  const double depth = a.s + b.s + c.s;
  const Vec3d depth_times_place = a.s * a.p + b.s * b.p + c.s * c.p + depth * (a.p + b.p + c.p);
  const double squared_depth = a.s * a.s + b.s * b.s + c.s * c.s + depth * depth;
  sum.volume -= projected * depth / 3;
  sum.first -= (projected / 12) * depth_times_place + (projected * squared_depth / 24) * up;
  sum.waterplane -= projected;
}

/// The part below the plane of a triangle with corners on both sides.
void add_cut_triangle(WetSum& sum, const std::array<Wet, 3>& corners, const Vec3d& up) {
  std::array<Wet, 4> below{};  // a clipped triangle has at most four corners
  std::size_t count = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const Wet &a = corners[c], &b = corners[(c + 1) % 3];
    if (a.s >= 0) below[count++] = a;
    if ((a.s > 0 && b.s < 0) || (a.s < 0 && b.s > 0)) below[count++] = {a.p + a.s / (a.s - b.s) * (b.p - a.p), 0};
  }
  for (std::size_t c = 2; c < count; ++c) add_wet_triangle(sum, below[0], below[c - 1], below[c], up);
}

WetSum wet_sum(const Surface& surface, std::size_t begin, std::size_t end, const Vec3d& origin, const Vec3d& up) {
  WetSum sum;
  for (std::size_t t = begin; t < end; ++t) {
    std::array<Wet, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) {
      corners[c].p = surface.corner(t, c) - origin;
      corners[c].s = -dot(up, corners[c].p);
    }
    const auto [low, high] = std::minmax({corners[0].s, corners[1].s, corners[2].s});
    if (low >= 0)
      add_wet_triangle(sum, corners[0], corners[1], corners[2], up);
    else if (high > 0)
      add_cut_triangle(sum, corners, up);
  }
  return sum;
}

}  // namespace

SubmergedVolume submerged(const Surface& surface, const Level& level) {
  EXPECTS(surface.is_closed());
  const SurfaceReport& report = surface.report();
  const Vec3d middle = report.bounds.centre(), half = 0.5 * (report.bounds.high - report.bounds.low);
  const double reach = std::fabs(level.up.x) * half.x + std::fabs(level.up.y) * half.y + std::fabs(level.up.z) * half.z;
  const double above = level.height - dot(level.up, middle);  // the plane over the middle
  if (above >= reach) return {report.volume, report.centroid, 0};
  if (above <= -reach) return {};

  const Vec3d origin = middle + above * level.up;  // as close as the plane allows, to avoid cancellation
  constexpr std::size_t block = 256;               // triangles per partial sum; these are added in order, for any number of threads
  const std::size_t triangles = surface.triangles().size();
  std::vector<WetSum> sums((triangles + block - 1) / block);
  parallel_for_uneven(static_cast<std::ptrdiff_t>(sums.size()), [&](std::ptrdiff_t b) {
    const std::size_t begin = static_cast<std::size_t>(b) * block;
    sums[static_cast<std::size_t>(b)] = wet_sum(surface, begin, std::min(begin + block, triangles), origin, level.up);
  });
  WetSum all;
  for (const WetSum& one : sums) all.volume += one.volume, all.first += one.first, all.waterplane += one.waterplane;
  if (all.volume <= 0) return {};  // rounding error only, where the plane barely intersects the surface
  return {all.volume, origin + all.first / all.volume, all.waterplane};
}

}  // namespace fccda
