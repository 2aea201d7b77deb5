/// Bounding boxes of consecutive slots of a point cloud, for the bond search: eight slots a leaf, eight boxes a node. The slots follow a
/// space-filling curve (discretisation/space_order.hpp), so that the boxes are compact and need no sorting, and a search visits slots in ascending order.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/aligned.hpp"
#include "base/pack.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

class SlotTree {
 public:
  explicit SlotTree(const Particles& particles);
  explicit SlotTree(std::span<const Vec3d> points);  ///< slot k: point k

  /// Calls visit(eight, squared, bits) in ascending order for the eight slots from 8·eight on, where at least one has a particle less than `reach` [m]
  /// from the point: bit l is set for slot l of these. `squared`: squared_norm() of the eight distances [m²], infinite without a particle.
  template <class Visit>
  void visit_near(const Vec3d& point, double reach, const Visit& visit) const {
    visit_children(boxes_.size(), 0, point, reach * reach, visit);
  }

 private:
  using Eight = std::array<double, fccda::byte_lanes>;
  struct Points {
    Eight at[3];
  };
  struct Boxes {
    Eight low[3], high[3];
  };

  /// Distances to the eight points, or lower bounds of those to the points in the boxes: the same rounding in both, so that bounds are never above distances.
  template <class Difference>
  static unsigned bits_below(double bound, Eight& squared, const Difference& difference) {
    using namespace fccda;
    using Pack = NativePack;
    unsigned bits = 0;
    for (std::size_t first = 0; first < byte_lanes; first += lanes<Pack>) {
      const Pack x = difference(std::size_t{0}, first), y = difference(std::size_t{1}, first), z = difference(std::size_t{2}, first);
      const Pack sum = x * x + y * y + z * z;
      store(squared.data() + first, sum);
      bits |= bits_where_greater(Pack(bound), sum) << first;
    }
    return bits;
  }

  /// Of node `node` above `level`; level 0: the points.
  template <class Visit>
  void visit_children(std::size_t level, std::size_t node, const Vec3d& point, double bound, const Visit& visit) const {
    using namespace fccda;
    using Pack = NativePack;
    Eight squared;
    if (level == 0) {
      const Points& points = points_[node];
      const unsigned bits =
          bits_below(bound, squared, [&](std::size_t axis, std::size_t first) { return load<Pack>(points.at[axis].data() + first) - Pack(point[axis]); });
      if (bits != 0) visit(node, squared, bits);
      return;
    }
    const Boxes& boxes = boxes_[level - 1][node];
    const unsigned bits = bits_below(bound, squared, [&](std::size_t axis, std::size_t first) {
      const Pack at(point[axis]);
      return larger(larger(load<Pack>(boxes.low[axis].data() + first) - at, at - load<Pack>(boxes.high[axis].data() + first)), Pack(0.0));
    });
    for_each_bit(bits, [&](std::size_t child) { visit_children(level - 1, node * byte_lanes + child, point, bound, visit); });
  }

  /// point_at(slot): the reference position of a particle there, or nothing.
  template <class PointAt>
  SlotTree(std::size_t slots, const PointAt& point_at);

  fccda::AlignedVector<Points> points_;
  std::vector<fccda::AlignedVector<Boxes>> boxes_;  // those around the points first, that of the root last
};

}  // namespace perimpact
