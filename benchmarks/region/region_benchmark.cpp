/// Rejection rate and cost of each kind of contact bounds: one CSV row per surface and bounds on standard output.
///
/// Points lie on a lattice in the surface's bounding box, and on one twice as large around it; each has a path of a thousandth of the size.
/// A row gives the share of points in the bounding box that the bounds reject, the cost of a test inside and around it, the cost of the lower
/// bound of the distance, and the cost of the surface query that is saved (closest-point search, 64 steps ahead).

#include <fmt/format.h>

#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "fccda/contact_bounds/boxes.hpp"
#include "fccda/contact_bounds/fit_boxes.hpp"
#include "fccda/contact_bounds/fit_contact_bounds.hpp"
#include "fccda/contact_bounds/fit_sectors.hpp"
#include "fixtures/propeller.hpp"
#include "fixtures/surfaces.hpp"
#include "mesh/search/bvh.hpp"

namespace {

using namespace fccda;

/// A ship hull: full amidships, fine at both ends, with keel and bilges; 10 by 2 by 1.
Panels hull() {
  return fixtures::moved(make_sphere({.diameter = 1, .edge_length = 0.02}), [](const Vec3d& p) {
    const double x = 2 * p.x, fullness = std::pow(std::max(0.0, 1 - x * x), -0.3);
    return Vec3d{10 * p.x, 2 * fullness * p.y, (p.z < 0 ? 1.6 : 0.4) * p.z};
  });
}

/// Process time, the minimum of several rounds.
template <class Ask>
double nanoseconds_each(std::size_t count, const Ask& ask) {
  double least = 1e300;
  for (int round = 0; round < 9; ++round) {
    const std::clock_t begin = std::clock();
    for (std::size_t i = 0; i < count; ++i) ask(i);
    least = std::min(least, 1e9 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least / static_cast<double>(count);
}

/// Paths on a lattice, x fastest, in the order of particles.
std::vector<Path> paths_in(const Box& box, double length) {
  constexpr int count = 60;
  std::mt19937_64 random(7);
  std::vector<Path> paths;
  const Vec3d step = box.size() / count;
  for (int k = 0; k < count; ++k)
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i) {
        const Vec3d start = box.low + Vec3d{(i + 0.5) * step.x, (j + 0.5) * step.y, (k + 0.5) * step.z};
        paths.push_back({start, start + length * fixtures::random_direction(random)});
      }
  return paths;
}

void measure(const std::string& name, const Panels& panels) {
  const Surface surface(panels);
  const Bvh bvh(surface);
  const Box bounds = surface.report().bounds;
  const double length = 1e-3 * norm(bounds.size());
  const std::vector<Path> near = paths_in(bounds, length), all = paths_in({bounds.centre() - bounds.size(), bounds.centre() + bounds.size()}, length);
  std::size_t sink = 0;
  int guess = -1;
  std::size_t tested = 0;
  const double look = nanoseconds_each(near.size(), [&](std::size_t i) {
    if (const std::optional<ClosestPoint> closest = bvh.closest(near[i].end, 64 * length, guess, tested)) guess = closest->triangle;
  });
  sink += tested;

  std::vector<std::pair<std::string, ContactBounds>> regions;
  for (const int most : {1, 4, 8, 16, 32}) {
    const std::vector<Box> boxes = fit_boxes(surface, {.most = most, .gain = 0});
    regions.emplace_back(fmt::format("{} boxes", boxes.size()), BoxUnion(boxes));
  }
  regions.emplace_back("sectors", CylinderSectors(fit_sectors(surface, {}), surface, Beyond::error));
  const FittedBounds chosen = fit_contact_bounds(surface);
  regions.emplace_back("auto", chosen.region);
  fmt::print(stderr, "{}: {}\n", name, chosen.choice);
  for (const auto& [kind, region] : regions) {
    std::visit(
        [&](const auto& its) {
          std::size_t kept = 0;
          for (const Path& path : near) kept += its.may_contact(path, length) ? 1 : 0;
          const double here = nanoseconds_each(near.size(), [&](std::size_t i) { sink += its.may_contact(near[i], length) ? 1 : 0; });
          const double everywhere = nanoseconds_each(all.size(), [&](std::size_t i) { sink += its.may_contact(all[i], length) ? 1 : 0; });
          const double distance = nanoseconds_each(near.size(), [&](std::size_t i) { sink += its.distance_at_least(near[i].end) > 0 ? 1 : 0; });
          fmt::print("{},{},{},{:.3f},{:.3f},{:.1f},{:.1f},{:.1f},{:.0f}\n", name, surface.triangles().size(), kind, its.volume() / volume_of(bounds),
                     1 - static_cast<double>(kept) / static_cast<double>(near.size()), here, everywhere, distance, look);
        },
        region);
  }
  if (sink == 0) fmt::print(stderr, "nothing found\n");
}

}  // namespace

int main() {
  fmt::print(
      "surface,triangles,region,share of the bounding box,rejected in it,may_contact in it [ns],may_contact around it [ns],distance [ns],query of the surface "
      "[ns]\n");
  measure("hull", hull());
  measure("propeller", fixtures::propeller({.edge_length = 0.01}));
  measure("skewed propeller", fixtures::propeller({.skew = 0.7, .edge_length = 0.01}));
}
