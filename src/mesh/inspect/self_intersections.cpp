#include "mesh/inspect/self_intersections.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

#include "base/parallel.hpp"
#include "mesh/inspect/crossing_triangles.hpp"

namespace fccda {
namespace {

enum Mark : std::uint8_t { crosses_another = 1, is_at_pocket = 2 };

class Inspection {
 public:
  Inspection(const Surface& surface, const Bvh& bvh)
      : surface_(surface),
        bvh_(bvh),
        step_(1e-9 * norm(surface.report().bounds.size())),
        solid_is_closed_(surface.solids(), true),
        marks_(surface.triangles().size(), 0) {
    for (std::size_t t = 0; t < marks_.size(); ++t)
      for (std::size_t e = 0; e < 3; ++e)
        if (surface.neighbour(t, e) < 0) solid_is_closed_[solid(t)] = false;
  }

  /// Marks triangle t and the triangles of higher number that intersect it. Returns how many these are.
  std::size_t mark_crossings(std::size_t t) {
    const TriangleCorners corners = corners_of(t);
    Box box;
    for (const Vec3d& corner : corners) box.include(corner);
    std::size_t count = 0;
    bvh_.visit_box(box, [&](int other) {
      const auto u = static_cast<std::size_t>(other);
      if (u <= t || surface_.solid_of(u) != surface_.solid_of(t)) return;
      const std::optional<Vec3d> at = crossing_of(corners, corners_of(u));
      if (!at) return;
      ++count;
      const Mark mark = is_pocket(t, u, *at) ? is_at_pocket : crosses_another;
      for (const std::size_t marked : {t, u}) std::atomic_ref(marks_[marked]).fetch_or(mark, std::memory_order_relaxed);
    });
    return count;
  }

  Defect panels_with(Mark mark, DefectKind kind) const {
    std::vector<std::size_t> marked;
    for (std::size_t t = 0; t < marks_.size(); ++t)
      if ((marks_[t] & mark) != 0) marked.push_back(t);
    return {kind, panels_of(surface_.triangles(), marked)};
  }

 private:
  TriangleCorners corners_of(std::size_t t) const { return {surface_.corner(t, 0), surface_.corner(t, 1), surface_.corner(t, 2)}; }
  std::size_t solid(std::size_t t) const { return static_cast<std::size_t>(surface_.solid_of(t)); }

  bool is_pocket(std::size_t t, std::size_t u, const Vec3d& at) const {
    if (!solid_is_closed_[solid(t)]) return false;
    const Vec3d before_both = surface_.normal(t) + surface_.normal(u);
    const double length = norm(before_both);
    return length > 0 && bvh_.enclosures(at + step_ / length * before_both, surface_.solid_of(t)) < 0;
  }

  const Surface& surface_;
  const Bvh& bvh_;
  double step_;  // [m] off the crossing: above the rounding of a ray's start, below the size of relevant features
  std::vector<bool> solid_is_closed_;
  std::vector<std::uint8_t> marks_;  // by triangle
};

}  // namespace

SelfIntersections self_intersections(const Surface& surface, const Bvh& bvh) {
  Inspection inspection(surface, bvh);
  constexpr std::size_t block = 1024;
  const std::size_t count = surface.triangles().size();
  std::vector<std::size_t> of_block((count + block - 1) / block, 0);
  parallel_for_uneven(static_cast<std::ptrdiff_t>(of_block.size()), [&](std::ptrdiff_t b) {
    const std::size_t begin = static_cast<std::size_t>(b) * block;
    for (std::size_t t = begin; t < std::min(begin + block, count); ++t) of_block[static_cast<std::size_t>(b)] += inspection.mark_crossings(t);
  });

  SelfIntersections out{std::accumulate(of_block.begin(), of_block.end(), std::size_t{0}), {}};
  const auto add = [&](Defect defect) {
    if (!defect.panels.empty()) out.defects.push_back(std::move(defect));
  };
  add(inspection.panels_with(crosses_another, DefectKind::self_intersection));
  add(inspection.panels_with(is_at_pocket, DefectKind::inside_out));
  return out;
}

void expect_no_pockets(const SelfIntersections& found, const std::string& name) {
  for (const Defect& defect : found.defects) {
    if (defect.kind != DefectKind::inside_out) continue;
    throw SurfaceError(name + ": " + std::to_string(defect.panels.size()) +
                           " panels intersect such that the surface is inside out between them, the first is panel " + std::to_string(defect.panels.front()) +
                           " (counted from 0): a particle could enter there without crossing a front; repair the fold where these panels intersect.",
                       defect);
  }
}

}  // namespace fccda
