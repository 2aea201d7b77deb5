#include "perimpact/discretisation/space_order.hpp"

#include <algorithm>
#include <utility>

namespace perimpact {

namespace {

constexpr int bits = 21;  // per axis: three of them fit a 64-bit word

/// The bits of a number, each followed by two zeros.
std::uint64_t spread(std::uint64_t number) {
  std::uint64_t out = 0;
  for (int b = 0; b < bits; ++b) out |= (number >> b & 1u) << (3 * b);
  return out;
}

}  // namespace

std::vector<std::uint32_t> space_order(std::span<const Vec3d> points) {
  fccda::Box bounds;
  for (const Vec3d& point : points) bounds.include(point);
  const double size = std::max({bounds.size().x, bounds.size().y, bounds.size().z});
  const double scale = size > 0 ? ((1 << bits) - 1) / size : 0;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::uint64_t key = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) key |= spread(static_cast<std::uint64_t>((points[k][axis] - bounds.low[axis]) * scale)) << axis;
    keys[k] = {key, static_cast<std::uint32_t>(k)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) order[k] = keys[k].second;
  return order;
}

}  // namespace perimpact
