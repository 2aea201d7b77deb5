#include "mesh/slivers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fccda {
namespace {

using Side = std::pair<int, int>;  // lower vertex, higher vertex

Side side_of(const Triangle& triangle, std::size_t e) { return std::minmax(triangle.vertex[e], triangle.vertex[(e + 1) % 3]); }

std::size_t longest_side(std::span<const Vec3d> vertices, const Triangle& triangle) {
  const auto squared_length = [&](std::size_t e) {
    const auto [from, to] = side_of(triangle, e);
    return squared_norm(vertices[static_cast<std::size_t>(from)] - vertices[static_cast<std::size_t>(to)]);
  };
  std::size_t longest = 0;
  for (const std::size_t e : {std::size_t{1}, std::size_t{2}}) {
    if (squared_length(e) > squared_length(longest)) longest = e;
  }
  return longest;
}

struct Sliver {
  Side longest;
  int middle;
  std::size_t triangle;
  std::size_t beyond = 0, beyond_side = 0;  // the triangle that may take the middle corner, and its side
  int candidates = 0;
};

/// Finds the slivers, sorted by their longest side, and the triangle beyond each: one with an area, or a sliver with the same longest side,
/// which thereby becomes shorter.
std::vector<Sliver> find(const std::vector<Triangle>& triangles, std::span<const Vec3d> vertices, double flat) {
  std::vector<Sliver> slivers;
  std::vector<bool> is_sliver(triangles.size(), false);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (has_area(vertices, triangles[t].vertex, flat)) continue;
    const std::size_t longest = longest_side(vertices, triangles[t]);
    slivers.push_back({side_of(triangles[t], longest), triangles[t].vertex[(longest + 2) % 3], t});
    is_sliver[t] = true;
  }
  if (slivers.empty()) return slivers;
  const auto by_side = [](const Sliver& a, const Sliver& b) { return a.longest < b.longest; };
  std::stable_sort(slivers.begin(), slivers.end(), by_side);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      if (is_sliver[t] && e != longest_side(vertices, triangles[t])) continue;
      const auto [first, last] = std::equal_range(slivers.begin(), slivers.end(), Sliver{side_of(triangles[t], e), 0, 0}, by_side);
      for (auto sliver = first; sliver != last; ++sliver) {
        if (sliver->triangle == t) continue;
        sliver->beyond = t;
        sliver->beyond_side = e;
        ++sliver->candidates;
      }
    }
  }
  return slivers;
}

}  // namespace

bool has_area(std::span<const Vec3d> vertices, const std::array<int, 3>& corners, double flat) {
  const Vec3d& a = vertices[static_cast<std::size_t>(corners[0])];
  const Vec3d& b = vertices[static_cast<std::size_t>(corners[1])];
  const Vec3d& c = vertices[static_cast<std::size_t>(corners[2])];
  const double longest = std::sqrt(std::max({squared_norm(b - a), squared_norm(c - b), squared_norm(a - c)}));
  return norm(cross(b - a, c - a)) > flat * longest;
}

std::size_t absorb_slivers(std::vector<Triangle>& triangles, std::span<const Vec3d> vertices, double flat) {
  std::size_t found = 0;
  constexpr int max_passes = 100;  // vertices on one straight edge; rounding could otherwise move slivers for ever
  for (int pass = 0; pass < max_passes; ++pass) {
    const std::vector<Sliver> slivers = find(triangles, vertices, flat);
    if (pass == 0) found = slivers.size();
    std::vector<bool> is_changed(triangles.size(), false);
    bool progress = false;
    for (const Sliver& sliver : slivers) {
      if (sliver.candidates != 1 || is_changed[sliver.triangle] || is_changed[sliver.beyond]) continue;
      is_changed[sliver.triangle] = is_changed[sliver.beyond] = progress = true;
      Triangle& beyond = triangles[sliver.beyond];
      Triangle& second = triangles[sliver.triangle] = beyond;
      beyond.vertex[(sliver.beyond_side + 1) % 3] = sliver.middle;
      second.vertex[sliver.beyond_side] = sliver.middle;
    }
    if (!progress) break;
  }
  if (found > 0) std::erase_if(triangles, [&](const Triangle& t) { return !has_area(vertices, t.vertex, flat); });
  return found;
}

}  // namespace fccda
