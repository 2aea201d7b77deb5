#include "fccda/inspect/self_intersections.hpp"

#include <algorithm>

#include "fccda/core/parallel.hpp"
#include "fccda/inspect/crossing_triangles.hpp"

namespace fccda {
namespace {

struct CrossingPair {
  int one, other;
  bool is_pocket;
};

class Inspection {
 public:
  Inspection(const Surface& surface, const Bvh& bvh) : surface_(surface), bvh_(bvh), step_(1e-9 * norm(surface.report().bounds.size())) {}

  /// Crossings of triangle t with those of higher numbers, in their order.
  void look_at(std::size_t t, std::vector<CrossingPair>& out) const {
    const TriangleCorners corners = corners_of(t);
    Box box;
    for (const Vec3d& corner : corners) box.include(corner);
    const std::size_t before = out.size();
    bvh_.visit_box(box, [&](int other) {
      const auto u = static_cast<std::size_t>(other);
      if (u <= t || surface_.solid_of(u) != surface_.solid_of(t)) return;
      if (const std::optional<Vec3d> at = crossing_of(corners, corners_of(u))) out.push_back({static_cast<int>(t), other, is_pocket(t, u, *at)});
    });
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(before), out.end(), [](const CrossingPair& a, const CrossingPair& b) { return a.other < b.other; });
  }

 private:
  TriangleCorners corners_of(std::size_t t) const { return {surface_.corner(t, 0), surface_.corner(t, 1), surface_.corner(t, 2)}; }

  bool is_pocket(std::size_t t, std::size_t u, const Vec3d& at) const {
    if (!surface_.is_closed()) return false;
    const Vec3d before_both = surface_.normal(t) + surface_.normal(u);
    const double length = norm(before_both);
    return length > 0 && bvh_.enclosures(at + step_ / length * before_both, surface_.solid_of(t)) < 0;
  }

  const Surface& surface_;
  const Bvh& bvh_;
  double step_;  // [m] off the crossing: above the rounding of a ray's start, below the size of anything that matters
};

void add_defect(std::vector<Defect>& defects, DefectKind kind, const Surface& surface, const std::vector<std::size_t>& triangles) {
  if (triangles.empty()) return;
  std::vector<int> panels;
  for (const std::size_t t : triangles) panels.push_back(surface.triangles()[t].panel);
  std::sort(panels.begin(), panels.end());
  panels.erase(std::unique(panels.begin(), panels.end()), panels.end());
  defects.push_back({kind, std::move(panels)});
}

}  // namespace

SelfIntersections self_intersections(const Surface& surface, const Bvh& bvh) {
  const Inspection inspection(surface, bvh);
  constexpr std::size_t block = 1024;
  const std::size_t count = surface.triangles().size();
  std::vector<std::vector<CrossingPair>> of_block((count + block - 1) / block);
  parallel_for_uneven(static_cast<std::ptrdiff_t>(of_block.size()), [&](std::ptrdiff_t b) {
    const std::size_t begin = static_cast<std::size_t>(b) * block;
    for (std::size_t t = begin; t < std::min(begin + block, count); ++t) inspection.look_at(t, of_block[static_cast<std::size_t>(b)]);
  });

  SelfIntersections out;
  std::vector<std::size_t> crossing, pockets;
  for (const std::vector<CrossingPair>& found : of_block) {
    out.crossings += found.size();
    for (const CrossingPair& one : found) {
      std::vector<std::size_t>& into = one.is_pocket ? pockets : crossing;
      into.insert(into.end(), {static_cast<std::size_t>(one.one), static_cast<std::size_t>(one.other)});
    }
  }
  add_defect(out.defects, DefectKind::self_intersection, surface, crossing);
  add_defect(out.defects, DefectKind::inside_out, surface, pockets);
  return out;
}

void expect_no_pockets(const SelfIntersections& found, const std::string& name) {
  for (const Defect& defect : found.defects) {
    if (defect.kind != DefectKind::inside_out) continue;
    throw SurfaceError(name + ": " + std::to_string(defect.panels.size()) +
                           " panels go through one another such that the surface is inside out between them, the first is panel " +
                           std::to_string(defect.panels.front()) +
                           " (counted from 0): a particle could get in there without meeting a front; mend the fold where these panels cross.",
                       defect);
  }
}

}  // namespace fccda
