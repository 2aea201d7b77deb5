#include "perimpact/family/slot_tree.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/parallel.hpp"

namespace perimpact {

using fccda::byte_lanes, fccda::eights_of;

namespace {

constexpr double far = std::numeric_limits<double>::infinity();

template <class F>
void for_each(std::size_t count, const F& f) {
  fccda::parallel_for(static_cast<std::ptrdiff_t>(count), [&](std::ptrdiff_t number) { f(static_cast<std::size_t>(number)); });
}

}  // namespace

SlotTree::SlotTree(const Particles& particles)
    : SlotTree(particles.slots(), [&](std::size_t slot) { return particles.is_occupied(slot) ? std::optional(particles.reference(slot)) : std::nullopt; }) {}

SlotTree::SlotTree(std::span<const Vec3d> points)
    : SlotTree(points.size(), [&](std::size_t slot) { return slot < points.size() ? std::optional(points[slot]) : std::nullopt; }) {}

template <class PointAt>
SlotTree::SlotTree(std::size_t slots, const PointAt& point_at) : points_(eights_of(slots)) {
  for_each(points_.size(), [&](std::size_t eight) {
    for (std::size_t lane = 0; lane < byte_lanes; ++lane) {
      const std::optional<Vec3d> point = point_at(eight * byte_lanes + lane);
      for (std::size_t axis = 0; axis < 3; ++axis) points_[eight].at[axis][lane] = point ? (*point)[axis] : far;
    }
  });
  const auto add_level = [&](std::size_t children, const auto& low_and_high_of) {
    fccda::AlignedVector<Boxes> level(eights_of(children));
    for_each(level.size(), [&](std::size_t node) {
      for (std::size_t lane = 0; lane < byte_lanes; ++lane) {
        const std::size_t child = node * byte_lanes + lane;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          // without particles below: low above high, infinitely far from every point
          auto [low, high] = child < children ? low_and_high_of(child, axis) : std::pair(far, -far);
          level[node].low[axis][lane] = low, level[node].high[axis][lane] = high;
        }
      }
    });
    boxes_.push_back(std::move(level));
  };
  add_level(points_.size(), [&](std::size_t child, std::size_t axis) {
    std::pair bounds(far, -far);
    for (const double at : points_[child].at[axis])
      if (at != far) bounds = {std::min(bounds.first, at), std::max(bounds.second, at)};
    return bounds;
  });
  while (boxes_.back().size() > 1) {
    const fccda::AlignedVector<Boxes>& below = boxes_.back();
    add_level(below.size(), [&](std::size_t child, std::size_t axis) {
      const Boxes& boxes = below[child];
      return std::pair(*std::ranges::min_element(boxes.low[axis]), *std::ranges::max_element(boxes.high[axis]));
    });
  }
}

}  // namespace perimpact
