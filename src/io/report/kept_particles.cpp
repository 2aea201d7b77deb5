#include "io/report/kept_particles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/contract.hpp"

namespace perimpact::report {

namespace {

using fccda::Vec3d;

/// Flags the particles that lack one of six lattice neighbours.
std::vector<bool> on_surface(std::span<const Vec3d> points, double spacing) {
  fccda::Box box;
  for (const Vec3d& point : points) box.include(point);
  constexpr double most_cells = 1 << 20;  // per axis, so that three indices fit into 64 bits
  const double cell = std::max(spacing, fccda::largest_magnitude(box.size()) / most_cells);
  const auto key = [](const std::array<std::int64_t, 3>& at) { return (at[0] * (std::int64_t{1} << 21) + at[1]) * (std::int64_t{1} << 21) + at[2]; };
  const auto place = [&](const Vec3d& point) {
    const Vec3d at = (point - box.low) / cell;
    return std::array<std::int64_t, 3>{std::lround(at.x) + 1, std::lround(at.y) + 1, std::lround(at.z) + 1};  // from 1: 0 is outside
  };
  std::vector<std::int64_t> taken;
  for (const Vec3d& point : points) taken.push_back(key(place(point)));
  std::sort(taken.begin(), taken.end());

  std::vector<bool> out(points.size(), false);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t face = 0; face < 6 && !out[i]; ++face) {
      std::array<std::int64_t, 3> beside = place(points[i]);
      beside[face / 2] += face % 2 == 0 ? 1 : -1;
      out[i] = !std::binary_search(taken.begin(), taken.end(), key(beside));
    }
  return out;
}

}  // namespace

std::vector<std::uint32_t> kept_particles(std::span<const Vec3d> undeformed, double spacing, const std::vector<bool>& is_damaged, double share) {
  EXPECTS(is_damaged.size() == undeformed.size() && spacing > 0);
  std::vector<bool> comes_first = on_surface(undeformed, spacing);
  std::size_t firsts = 0;
  for (std::size_t i = 0; i < comes_first.size(); ++i) {
    comes_first[i] = comes_first[i] || is_damaged[i];
    firsts += comes_first[i];
  }
  const double wanted = std::min(share, 1.0) * static_cast<double>(undeformed.size()), rest = static_cast<double>(undeformed.size() - firsts);
  const double share_of_firsts = firsts == 0 ? 0 : std::min(1.0, wanted / static_cast<double>(firsts));
  const double share_of_rest = rest == 0 ? 0 : std::clamp((wanted - static_cast<double>(firsts)) / rest, 0.0, 1.0);

  std::vector<std::uint32_t> kept;
  double due_first = 0.5, due_rest = 0.5;  // error diffusion: a particle is kept whenever the sum reaches an integer
  for (std::size_t i = 0; i < comes_first.size(); ++i) {
    double& due = comes_first[i] ? due_first : due_rest;
    due += comes_first[i] ? share_of_firsts : share_of_rest;
    if (due < 1) continue;
    due -= 1;
    kept.push_back(static_cast<std::uint32_t>(i));
  }
  if (kept.empty() && !undeformed.empty()) kept.push_back(0);
  return kept;
}

}  // namespace perimpact::report
