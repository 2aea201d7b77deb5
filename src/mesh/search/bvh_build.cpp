// Construction: split by the surface area heuristic (SAH; Goldsmith and Salmon 1987; binned after Wald 2007), four ways at a time.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "base/contract.hpp"
#include "base/parallel.hpp"
#include "mesh/search/bvh.hpp"

namespace fccda {

namespace {

double half_area(const Box& box) {
  if (box.is_empty()) return 0;
  const Vec3d s = box.size();
  return s.x * s.y + s.y * s.z + s.z * s.x;
}

void include(Box& box, const Box& other) {
  box.low = min(box.low, other.low);
  box.high = max(box.high, other.high);
}

/// Covers the rounding of a query's coordinates and of the boxes' own. `all` [m]: relative to the origin of the tree.
double slack_of(const Box& all) { return 0x1p-20 * std::fmax(largest_magnitude(all.low), largest_magnitude(all.high)); }

double leaves_for(std::size_t triangles) { return static_cast<double>((triangles + 3) / 4); }

}  // namespace

class Bvh::Builder {
 public:
  Builder(Bvh& bvh, const Surface& surface, std::span<const std::int32_t> triangles)
      : bvh_(bvh), surface_(surface), triangles_(triangles), order_(triangles.size()), boxes_(triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    Box all;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) boxes_[i].include(surface.corner(static_cast<std::size_t>(triangles[i]), c) - bvh.origin_);
      include(all, boxes_[i]);
    }
    slack_ = slack_of(all);
    bvh.worthwhile_ = 0.3 * std::sqrt(surface.report().area / static_cast<double>(surface.triangles().size()));
    add_node(order_, 0);
  }

 private:
  using Range = std::span<std::int32_t>;
  static constexpr int deepest_uneven = 100;  // halves from there on: at most 16 further levels, which bounds the stack of a query

  const Box& box(std::int32_t i) const { return boxes_[static_cast<std::size_t>(i)]; }

  Box bounds(Range range) const {
    Box all;
    for (const std::int32_t i : range) include(all, box(i));
    return all;
  }

  /// Splits in two such that the expected number of leaves visited by a query is least.
  std::array<Range, 2> split(Range range, int level) const {
    constexpr std::size_t bins = 16;
    Box middles;
    for (const std::int32_t i : range) middles.include(box(i).centre());
    double best_cost = std::numeric_limits<double>::infinity(), best_plane = 0;
    std::size_t best_axis = 3;
    for (std::size_t axis = 0; axis < 3 && level < deepest_uneven; ++axis) {
      const double low = middles.low[axis], extent = middles.size()[axis];
      if (!(extent > 0)) continue;
      struct Bin {
        Box box;
        std::size_t count = 0;
      };
      std::array<Bin, bins> bin;
      for (const std::int32_t i : range) {
        const auto b = static_cast<std::size_t>((box(i).centre()[axis] - low) / extent * bins);
        Bin& into = bin[std::min(b, bins - 1)];
        include(into.box, box(i));
        ++into.count;
      }
      std::array<double, bins> cost_above{};
      Bin above;
      for (std::size_t b = bins - 1; b > 0; --b) {
        include(above.box, bin[b].box);
        above.count += bin[b].count;
        cost_above[b] = half_area(above.box) * leaves_for(above.count);
      }
      Bin below;
      for (std::size_t b = 1; b < bins; ++b) {
        include(below.box, bin[b - 1].box);
        below.count += bin[b - 1].count;
        const double cost = half_area(below.box) * leaves_for(below.count) + cost_above[b];
        if (below.count > 0 && below.count < range.size() && cost < best_cost) best_cost = cost, best_axis = axis, best_plane = static_cast<double>(b);
      }
    }
    std::size_t below = range.size() / 2;  // all coincident, or too deep: any halves are suitable
    if (best_axis < 3) {
      const double low = middles.low[best_axis], extent = middles.size()[best_axis];
      const auto middle = std::stable_partition(range.begin(), range.end(), [&](std::int32_t i) {
        return std::min(std::floor((box(i).centre()[best_axis] - low) / extent * bins), bins - 1.0) < best_plane;
      });
      below = static_cast<std::size_t>(middle - range.begin());
    }
    return {range.first(below), range.subspan(below)};
  }

  std::int32_t add_node(Range range, int level) {
    std::array<Range, width> parts{range};
    std::size_t count = 1;
    while (count < width) {  // split the part that a query most probably enters
      std::size_t widest = width;
      double area = -1;
      for (std::size_t p = 0; p < count; ++p) {
        const double its = parts[p].size() > width ? half_area(bounds(parts[p])) : -1;
        if (its > area) area = its, widest = p;
      }
      if (widest == width) break;
      const auto [below, above] = split(parts[widest], level);
      parts[widest] = below;
      parts[count++] = above;
    }
    const auto index = static_cast<std::size_t>(bvh_.nodes_.size());
    bvh_.nodes_.emplace_back();
    for (std::size_t p = 0; p < width; ++p) {
      const bool leaf = parts[p].size() <= width;
      const std::int32_t child = p >= count ? -1 : leaf ? ~add_leaf(parts[p]) : add_node(parts[p], level + 1);
      constexpr double beyond = std::numeric_limits<double>::infinity();
      const Box its = p < count ? bounds(parts[p]) : Box{{beyond, beyond, beyond}, {-beyond, -beyond, -beyond}};
      Node& node = bvh_.nodes_[index];
      node.child[p] = child;
      set_box(node, p, its, slack_);
    }
    return static_cast<std::int32_t>(index);
  }

  std::int32_t add_leaf(Range range) {
    EXPECTS(!range.empty() && range.size() <= width);
    const auto index = static_cast<std::int32_t>(bvh_.leaves_.size());
    std::sort(range.begin(), range.end());
    Leaf leaf{};
    leaf.count = static_cast<std::int32_t>(range.size());
    for (std::size_t l = 0; l < width; ++l) {
      const std::int32_t triangle = triangles_[static_cast<std::size_t>(range[std::min(l, range.size() - 1)])];
      leaf.triangle[l] = triangle;
      if (!bvh_.leaf_of_.empty()) bvh_.leaf_of_[static_cast<std::size_t>(triangle)] = index;
    }
    bvh_.fill(leaf);
    bvh_.leaves_.push_back(leaf);
    return index;
  }

  Bvh& bvh_;
  const Surface& surface_;
  std::span<const std::int32_t> triangles_;
  std::vector<std::int32_t> order_;  // indices into the list of triangles
  std::vector<Box> boxes_;
  double slack_ = 0;
};

// The triangles of a leaf by coordinate.
void Bvh::fill(Leaf& leaf) const {
  set_corners(leaf, origin_, [&](std::size_t k) { return surface_->corner(static_cast<std::size_t>(leaf.triangle[k / 3]), k % 3); });
}

// Once refitted, a leaf is filled whenever it is read, into `room`.
const Bvh::Leaf& Bvh::current_leaf(std::int32_t index, Leaf& room) const {
  const Leaf& leaf = leaves_[static_cast<std::size_t>(index)];
  if (leaf_vertices_.empty()) return leaf;
  room.triangle = leaf.triangle, room.count = leaf.count;
  const auto& numbers = leaf_vertices_[static_cast<std::size_t>(index)];
  const std::span<const Vec3d> vertices = surface_->vertices();
  set_corners(room, origin_, [&](std::size_t k) -> const Vec3d& { return vertices[static_cast<std::size_t>(numbers[k])]; });
  return room;
}

void Bvh::set_box(Node& node, std::size_t child, const Box& box, double slack) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node.low[axis][child] = static_cast<float>(box.low[axis] - slack);
    node.high[axis][child] = static_cast<float>(box.high[axis] + slack);
  }
}

Bvh::Bvh(const Bvh& tree, const Surface& surface) : Bvh(tree) {
  EXPECTS(surface.triangles().size() == tree.surface_->triangles().size());
  surface_ = &surface;
  refit();
}

void Bvh::list_leaf_vertices() {
  leaf_vertices_.resize(leaves_.size());
  for (std::size_t k = 0; k < leaves_.size(); ++k)
    for (std::size_t l = 0; l < width; ++l)
      std::ranges::copy(surface_->triangles()[static_cast<std::size_t>(leaves_[k].triangle[l])].vertex,
                        leaf_vertices_[k].begin() + static_cast<std::ptrdiff_t>(3 * l));
}

// A node comes before its children, so the boxes of nodes are united backwards, after those of the leaves. Leaves are left outdated: they are most of
// the memory, and few are visited in a step.
void Bvh::refit() {
  if (leaf_vertices_.empty()) list_leaf_vertices();
  const std::span<const Vec3d> vertices = surface_->vertices();
  const Box& bounds = surface_->report().bounds;
  origin_ = bounds.centre();
  const double slack = slack_of({bounds.low - origin_, bounds.high - origin_});
  const auto is_child = [](const Node& node, std::size_t c) { return node.low[0][c] <= node.high[0][c]; };
  parallel_for(static_cast<std::ptrdiff_t>(nodes_.size()), [&](std::ptrdiff_t k) {
    Node& node = nodes_[static_cast<std::size_t>(k)];
    for (std::size_t c = 0; c < width; ++c) {
      if (node.child[c] >= 0 || !is_child(node, c)) continue;
      Box box;
      for (const std::int32_t vertex : leaf_vertices_[static_cast<std::size_t>(~node.child[c])]) box.include(vertices[static_cast<std::size_t>(vertex)]);
      set_box(node, c, {box.low - origin_, box.high - origin_}, slack);
    }
  });
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    for (std::size_t c = 0; c < width; ++c) {
      if (node.child[c] < 0) continue;
      const Node& below = nodes_[static_cast<std::size_t>(node.child[c])];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node.low[axis][c] = *std::min_element(below.low[axis].begin(), below.low[axis].end());
        node.high[axis][c] = *std::max_element(below.high[axis].begin(), below.high[axis].end());
      }
    }
  }
}

double Bvh::cost() const {
  Box all;
  double sum = 0;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Node& node = nodes_[n];
    for (std::size_t c = 0; c < width; ++c) {
      if (!(node.low[0][c] <= node.high[0][c])) continue;
      const auto corner = [&](const auto& of) { return Vec3d{of[0][c], of[1][c], of[2][c]}; };
      const Box box{corner(node.low), corner(node.high)};
      sum += half_area(box);
      if (n == 0) include(all, box);
    }
  }
  return sum / half_area(all);
}

Bvh::Bvh(const Surface& surface) : surface_(&surface), origin_(surface.report().bounds.centre()), leaf_of_(surface.triangles().size()) {
  EXPECTS(!surface.triangles().empty());
  std::vector<std::int32_t> all(surface.triangles().size());
  std::iota(all.begin(), all.end(), 0);
  Builder(*this, surface, all);
  nodes_.shrink_to_fit();  // of a large surface, half of what they have grown to
  leaves_.shrink_to_fit();
}

Bvh::Bvh(const Surface& surface, std::span<const std::int32_t> triangles) : surface_(&surface), origin_(surface.report().bounds.centre()) {
  EXPECTS(!triangles.empty() && std::is_sorted(triangles.begin(), triangles.end()));
  Builder(*this, surface, triangles);
}

}  // namespace fccda
