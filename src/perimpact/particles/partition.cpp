#include "perimpact/particles/partition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/pack.hpp"

namespace perimpact {

namespace {

constexpr double cost_of_ghost = 0.3;  // of the cost of a cell that is computed: packed, sent, unpacked and kept up to date

struct Cut {
  std::size_t axis;
  int at;  // cell
  double cost;
};

/// The best cut across an axis, for `first` of `ranks` on its lower side; cost infinite if there is none.
Cut best_cut(const CellBox& box, std::size_t axis, int first, int ranks, const PartitionRule& rule) {
  const int unit = axis == 0 ? static_cast<int>(fccda::byte_lanes) : 1, size = box.size(axis), units = (size + unit - 1) / unit;
  if (units < 2 || (axis == 2 && rule.keeps_columns)) return {axis, 0, std::numeric_limits<double>::infinity()};
  const double share = static_cast<double>(first) / ranks;
  const int lower = std::clamp(static_cast<int>(std::lround(share * size / unit)), 1, units - 1) * unit;
  const double imbalance = std::max(lower / (share * size), (size - lower) / ((1 - share) * size)) - 1;
  return {axis, box.low[axis] + lower, imbalance + cost_of_ghost * 2 * rule.reach / size};
}

void bisect(const CellBox& box, int ranks, const PartitionRule& rule, std::vector<CellBox>& boxes) {
  const int first = ranks / 2;
  Cut best{0, 0, std::numeric_limits<double>::infinity()};
  if (ranks > 1)
    for (const std::size_t axis : {2u, 1u, 0u})  // planes of cells are contiguous in memory
      if (const Cut cut = best_cut(box, axis, first, ranks, rule); cut.cost < best.cost) best = cut;
  if (!std::isfinite(best.cost)) return boxes.push_back(box);
  CellBox lower = box, upper = box;
  lower.high[best.axis] = upper.low[best.axis] = best.at;
  bisect(lower, first, rule, boxes);
  bisect(upper, ranks - first, rule, boxes);
}

}  // namespace

std::vector<CellBox> partition(const PartitionRule& rule, int ranks) {
  std::vector<CellBox> boxes;
  bisect({{0, 0, 0}, rule.cells}, ranks, rule, boxes);
  return boxes;
}

}  // namespace perimpact
