#include "fccda/contact_bounds/angular_occupancy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "fccda/contact_bounds/wedge.hpp"

namespace fccda {

namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr int hub_steps = 64;
constexpr int most_blades = 10;
constexpr std::size_t most_bins = 2520;  // of a turn: divisible by 1 to 10

/// [0, turn)
double wrapped(double angle, double period) {
  const double rest = angle - period * std::floor(angle / period);
  return rest < period ? rest : 0;
}

/// The widest run of free bins, on the circle.
std::size_t widest_gap(const std::vector<bool>& taken) {
  const auto first = std::find(taken.begin(), taken.end(), true);
  if (first == taken.end()) return taken.size();
  const auto start = static_cast<std::size_t>(first - taken.begin());
  std::size_t widest = 0, run = 0;
  for (std::size_t k = 0; k < taken.size(); ++k) {
    run = taken[(start + k) % taken.size()] ? 0 : run + 1;
    widest = std::max(widest, run);
  }
  return widest;
}

std::vector<bool> folded(const std::vector<bool>& taken, int times) {
  std::vector<bool> all(taken.size() / static_cast<std::size_t>(times), false);
  for (std::size_t k = 0; k < taken.size(); ++k)
    if (taken[k]) all[k % all.size()] = true;
  return all;
}

/// Area of the cross-section outside the hub, over radius²/2.
double area(double hub, double radius, int blades, double sector_angle) {
  const double share = hub / radius * (hub / radius);
  const double covered = sector_angle < 0.5 * turn ? std::min(blades * sector_angle, turn) : turn;
  return turn * share + covered * (1 - share);
}

}  // namespace

AngularOccupancy::AngularOccupancy(const Surface& surface, const CylinderFrame& frame)
    : low_(std::numeric_limits<double>::infinity()), high_(-std::numeric_limits<double>::infinity()) {
  for (const Vec3d& vertex : surface.vertices()) {
    const Vec3d place = frame.to_frame(vertex);
    radius_ = std::max(radius_, norm(Flat{place.x, place.y}));
    low_ = std::min(low_, place.z), high_ = std::max(high_, place.z);
  }
  longest_ = radius_ / hub_steps;
  for (std::size_t t = 0; t < surface.triangles().size(); ++t)
    add(frame.to_frame(surface.corner(t, 0)), frame.to_frame(surface.corner(t, 1)), frame.to_frame(surface.corner(t, 2)));
}

// Halves the triangle, in projection along the axis, until it is short. A short one that does not contain the axis occupies the angles between
// its corners.
void AngularOccupancy::add(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const std::array<Flat, 3> p{{{a.x, a.y}, {b.x, b.y}, {c.x, c.y}}};
  std::array<double, 3> edge;
  for (std::size_t e = 0; e < 3; ++e) edge[e] = norm(Flat{p[(e + 1) % 3].x - p[e].x, p[(e + 1) % 3].y - p[e].y});
  const auto longest = static_cast<std::size_t>(std::max_element(edge.begin(), edge.end()) - edge.begin());
  if (edge[longest] > longest_) {
    const std::array<Vec3d, 3> corner{a, b, c};
    const Vec3d &one = corner[longest], &next = corner[(longest + 1) % 3], &far = corner[(longest + 2) % 3];
    const Vec3d middle = 0.5 * (one + next);
    add(one, middle, far);
    add(middle, next, far);
    return;
  }
  const double start = std::atan2(a.y, a.x);
  double from = 0, to = 0;
  for (const Flat& corner : {p[1], p[2]}) {
    const double angle = std::remainder(std::atan2(corner.y, corner.x) - start, turn);
    from = std::min(from, angle), to = std::max(to, angle);
  }
  const bool may_hold_axis = to - from >= 0.5 * turn * (1 - 1e-9);
  const double furthest = std::max({norm(p[0]), norm(p[1]), norm(p[2])});
  pieces_.push_back({furthest, may_hold_axis ? 0 : wrapped(start + from, turn), may_hold_axis ? turn : to - from});
}

/// Bins of the turn that are occupied by pieces beyond each hub radius.
std::vector<std::vector<bool>> AngularOccupancy::occupied_beyond(const std::vector<double>& hubs, std::size_t bins) const {
  std::vector<std::vector<bool>> taken(hubs.size(), std::vector<bool>(bins, false));
  for (const Piece& piece : pieces_) {
    // up to the largest hub that does not contain it
    const auto beyond = std::lower_bound(hubs.begin(), hubs.end(), piece.furthest);
    if (beyond == hubs.begin()) continue;
    std::vector<bool>& its = taken[static_cast<std::size_t>(beyond - hubs.begin()) - 1];
    const double per_bin = turn / static_cast<double>(bins);
    const auto first = static_cast<std::size_t>(piece.start / per_bin), last = static_cast<std::size_t>((piece.start + piece.width) / per_bin);
    for (std::size_t bin = first; bin <= std::min(last, first + bins - 1); ++bin) its[bin % bins] = true;
  }
  for (std::size_t hub = hubs.size() - 1; hub > 0; --hub)
    for (std::size_t bin = 0; bin < bins; ++bin)
      if (taken[hub][bin]) taken[hub - 1][bin] = true;
  return taken;
}

// Exact: the angles of the pieces, modulo the angle between blades.
SectorFan AngularOccupancy::fan_around(double hub_radius, int blades) const {
  const double period = turn / blades;
  std::vector<std::pair<double, double>> runs;
  for (const Piece& piece : pieces_)
    if (piece.furthest > hub_radius) runs.emplace_back(wrapped(piece.start, period), piece.width);
  if (runs.empty()) return {.hub_radius = hub_radius, .blades = blades};
  std::sort(runs.begin(), runs.end());
  double reached = 0, gap = 0, after_gap = 0;
  for (const auto& [start, width] : runs) reached = std::max(reached, start + width);
  reached -= period;  // wraps around to the begin of the first
  for (const auto& [start, width] : runs) {
    if (start - reached > gap) gap = start - reached, after_gap = start;
    reached = std::max(reached, start + width);
  }
  return {.hub_radius = hub_radius, .blades = blades, .sector_angle = period - gap, .start_angle = after_gap};
}

SectorFan AngularOccupancy::smallest_fan(std::optional<double> hub_radius, std::optional<int> blades) const {
  std::vector<double> hubs;
  for (int k = 0; k < hub_steps; ++k) hubs.push_back(radius_ * k / hub_steps);
  if (hub_radius) hubs = {*hub_radius};
  const std::size_t bins = blades ? static_cast<std::size_t>(*blades) * std::max<std::size_t>(1, most_bins / static_cast<std::size_t>(*blades)) : most_bins;
  const std::vector<std::vector<bool>> taken = occupied_beyond(hubs, bins);
  double best_hub = hubs.front(), least = std::numeric_limits<double>::infinity();
  int best_blades = 1;
  for (std::size_t h = 0; h < hubs.size(); ++h) {
    for (int n = blades.value_or(1); n <= blades.value_or(most_blades); ++n) {
      const std::vector<bool> all = folded(taken[h], n);
      const double sector = turn / n * (1 - static_cast<double>(widest_gap(all)) / static_cast<double>(all.size()));
      const double its = area(hubs[h], radius_, n, sector);
      if (its < least) least = its, best_hub = hubs[h], best_blades = n;
    }
  }
  return fan_around(best_hub, best_blades);
}

}  // namespace fccda
