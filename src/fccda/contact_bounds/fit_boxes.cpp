#include "fccda/contact_bounds/fit_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fccda/contact_bounds/boxes.hpp"
#include "fccda/contact_bounds/exceeding_panels.hpp"
#include "mesh/polygon.hpp"
#include "mesh/ray_crossing.hpp"

namespace fccda {

namespace {

constexpr int slabs = 16;  // between planes

/// A splitting plane. Pieces that lie in it may go with either side.
struct Plane {
  std::size_t axis = 0;
  double at = 0;
  Side in_plane = Side::below;
};

struct Split {
  Plane plane;
  Box below, above;   // around the pieces on each side
  double saving = 0;  // [m³]
};

struct Cell {
  Box box;
  std::vector<Polygon> pieces;
  Split best;
};

/// The volume enclosed by a closed surface.
class Inside {
 public:
  explicit Inside(const Surface& surface) : surface_(surface) {}

  bool contains(const Vec3d& point) const {
    if (!surface_.is_closed() || !fccda::contains(surface_.report().bounds, point)) return false;
    const RayCrossing crosses(surface_.vertices(), surface_.triangles());
    int bodies = 0;
    for (std::size_t t = 0; t < surface_.triangles().size(); ++t) bodies += crosses(point, t);
    return bodies > 0;
  }

  /// The box around the pieces in a cell, extended to contain the enclosed volume there: with the corners of the cell that are inside. That is
  /// sufficient: where the enclosed volume reaches a face of the cell, either the surface does too, or the whole face is inside, with its
  /// corners. Corners are tested slightly inside the cell, so that a corner on a panel along the cell does not count.
  Box with_inside(Box pieces, const Box& cell) const {
    constexpr double hair = 1e-6;
    for (int c = 0; c < 8; ++c) {
      const Vec3d corner{c & 1 ? cell.high.x : cell.low.x, c & 2 ? cell.high.y : cell.low.y, c & 4 ? cell.high.z : cell.low.z};
      if (!fccda::contains(pieces, corner) && contains(corner + hair * (cell.centre() - corner))) pieces.include(corner);
    }
    return pieces;
  }

 private:
  const Surface& surface_;
};

Box half(Box cell, const Plane& plane, Side side) {
  (side == Side::below ? cell.high : cell.low)[plane.axis] = plane.at;
  return cell;
}

Box both(const Box& a, const Box& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  return {min(a.low, b.low), max(a.high, b.high)};
}

/// The slabs that a piece reaches into, with a tolerance: a piece beyond a plane by rounding alone is not cut there. Last < first: in the
/// plane before slab `first`.
struct Reach {
  int first, last;

  Reach(double low, double high, double start, double width) {
    constexpr double tolerance = 1e-9;  // in slabs
    first = std::clamp(static_cast<int>(std::floor((low - start) / width + tolerance)), 0, slabs);
    last = std::clamp(static_cast<int>(std::ceil((high - start) / width - tolerance)) - 1, -1, slabs - 1);
    if (first == slabs) first = last = slabs - 1;
    if (last == -1) first = last = 0;
  }
};

/// The boxes around the pieces in each slab across an axis, and around those in the planes between.
struct Slabs {
  std::size_t axis;
  double start, width;
  std::array<Box, slabs> of{};
  std::array<Box, slabs> in_plane{};  // before slab k

  double plane(int k) const { return start + k * width; }

  Slabs(const Cell& cell, std::size_t across) : axis(across), start(cell.box.low[across]), width(cell.box.size()[across] / slabs) {
    for (const Polygon& piece : cell.pieces) {
      const Box bounds = bounds_of(piece);
      const Reach reach(bounds.low[axis], bounds.high[axis], start, width);
      Box& its = reach.last < reach.first ? in_plane[index(reach.first)] : of[index(reach.first)];
      if (reach.last <= reach.first) {
        its = both(its, bounds);
        continue;
      }
      Polygon rest = piece;
      for (int k = reach.first; k < reach.last; ++k) {
        of[index(k)] = both(of[index(k)], bounds_of(part_of(rest, Side::below, axis, plane(k + 1))));
        rest = part_of(rest, Side::above, axis, plane(k + 1));
      }
      of[index(reach.last)] = both(of[index(reach.last)], bounds_of(rest));
    }
  }

  /// The boxes on both sides of the plane before slab k.
  Split split(int k, Side plane_goes) const {
    Split split{.plane = {axis, plane(k), plane_goes}};
    for (int s = 0; s < slabs; ++s) {
      Box& side = s < k ? split.below : split.above;
      side = both(side, of[index(s)]);
      if (s == k)
        (plane_goes == Side::below ? split.below : split.above) = both(plane_goes == Side::below ? split.below : split.above, in_plane[index(s)]);
      else
        side = both(side, in_plane[index(s)]);
    }
    return split;
  }

 private:
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }
};

double saving(const Box& cell, const Split& split) { return volume_of(cell) - volume_of(split.below) - volume_of(split.above); }

/// The split with the largest saving. The enclosed volume can only reduce a saving, so splits are evaluated in descending order of the estimate
/// until none can be better.
Split best_split(const Cell& cell, const Inside& inside) {
  std::vector<Split> splits;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(cell.box.size()[axis] > 0)) continue;
    const Slabs across(cell, axis);
    for (int k = 1; k < slabs; ++k)
      for (const Side side : {Side::below, Side::above}) {
        Split split = across.split(k, side);
        split.saving = saving(cell.box, split);
        splits.push_back(split);
      }
  }
  std::stable_sort(splits.begin(), splits.end(), [](const Split& a, const Split& b) { return a.saving > b.saving; });
  Split best;
  for (Split& split : splits) {
    if (split.saving <= best.saving) break;
    split.below = inside.with_inside(split.below, half(cell.box, split.plane, Side::below));
    split.above = inside.with_inside(split.above, half(cell.box, split.plane, Side::above));
    split.saving = saving(cell.box, split);
    if (split.saving > best.saving) best = split;
  }
  return best;
}

/// The pieces of a cell on one side of its split, cut by the same rule as in Slabs.
std::vector<Polygon> pieces_on(Side side, const Cell& cell) {
  const Plane& plane = cell.best.plane;
  const double tolerance = 1e-9 * cell.box.size()[plane.axis] / slabs;
  std::vector<Polygon> pieces;
  for (const Polygon& piece : cell.pieces) {
    const Box bounds = bounds_of(piece);
    const bool is_below = bounds.high[plane.axis] <= plane.at + tolerance, is_above = bounds.low[plane.axis] >= plane.at - tolerance;
    if (is_below && is_above) {
      if (side == plane.in_plane) pieces.push_back(piece);
    } else if (is_below || is_above) {
      if ((side == Side::below) == is_below) pieces.push_back(piece);
    } else {
      pieces.push_back(part_of(piece, side, plane.axis, plane.at));
    }
  }
  return pieces;
}

}  // namespace

std::vector<Box> fit_boxes(const Surface& surface, const BoxFit& wanted) {
  const Inside inside(surface);
  Cell whole{.box = surface.report().bounds};
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) whole.pieces.push_back({surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)});
  whole.best = best_split(whole, inside);

  // A smaller share is rounding.
  const double least_saving = std::max(wanted.gain, 1e-9) * volume_of(whole.box);
  std::vector<Cell> cells;
  cells.push_back(std::move(whole));
  while (static_cast<int>(cells.size()) < wanted.most) {
    const auto promising = std::max_element(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.best.saving < b.best.saving; });
    if (!(promising->best.saving > 0 && promising->best.saving >= least_saving)) break;
    const Cell parent = std::move(*promising);
    cells.erase(promising);
    for (const Side side : {Side::below, Side::above}) {
      Cell child{.box = side == Side::below ? parent.best.below : parent.best.above, .pieces = pieces_on(side, parent)};
      for (const Polygon& piece : child.pieces) child.box = both(child.box, bounds_of(piece));
      if (child.box.is_empty()) continue;
      child.best = best_split(child, inside);
      cells.push_back(std::move(child));
    }
  }

  std::vector<Box> boxes;
  for (const Cell& cell : cells) boxes.push_back(widened(cell.box, widening(surface)));
  return boxes;
}

}  // namespace fccda
