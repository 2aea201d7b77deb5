#include "perimpact/particles/partition.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

#include "base/pack.hpp"

namespace perimpact {

namespace {

constexpr double cost_of_ghost = 0.3;  // of the cost of a cell that is computed: packed, sent, unpacked and kept up to date

/// Cells that a cut across this axis may not divide.
int unit_of(std::size_t axis) { return axis == 0 ? static_cast<int>(fccda::byte_lanes) : 1; }

int units_of(int cells, std::size_t axis) { return (cells + unit_of(axis) - 1) / unit_of(axis); }

/// Largest work of a rank, in cells of mean cost that are computed.
double largest_work(const std::vector<CellBox>& boxes, const PartitionRule& rule) {
  const CellBox all{{0, 0, 0}, rule.cells};
  const double mean_cost = cost_of(rule.load, all) / static_cast<double>(all.cells());
  double largest = 0;
  for (const CellBox& box : boxes) {
    const CellBox around = intersection(box.grown({rule.reach, rule.reach, rule.reach}), all);
    const auto cells = static_cast<double>(box.cells());
    const double computed = rule.load.empty() ? cells : cost_of(rule.load, box) / mean_cost;
    largest = std::max(largest, computed + cost_of_ghost * (static_cast<double>(around.cells()) - cells));
  }
  return largest;
}

using Parts = std::array<int, 3>;  // boxes along each axis

/// Work of an interior box of the largest size in a grid, or of one with fewer neighbours where there is no interior.
double largest_work(const Parts& parts, const PartitionRule& rule) {
  double own = 1, around = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int units = units_of(rule.cells[axis], axis), most = (units + parts[axis] - 1) / parts[axis] * unit_of(axis);
    const int size = std::min(most, rule.cells[axis]), sides = std::min(parts[axis] - 1, 2);
    own *= size;
    around *= std::min(size + sides * rule.reach, rule.cells[axis]);
  }
  return own + cost_of_ghost * (around - own);
}

/// The grid with the least work of the busiest rank; nothing if none has a unit for every box, and no box narrower than the reach.
std::optional<Parts> best_parts(const PartitionRule& rule, int ranks) {
  std::optional<Parts> best;
  double least = std::numeric_limits<double>::infinity();
  const auto is_possible = [&](int parts, std::size_t axis) {
    if (parts == 1) return true;
    const int units = units_of(rule.cells[axis], axis), narrowest = units / parts * unit_of(axis) - (units * unit_of(axis) - rule.cells[axis]);
    return narrowest >= std::max(1, rule.reach) && !(axis == 2 && rule.keeps_columns);
  };
  for (int x = 1; x <= ranks; ++x)
    for (int y = 1; ranks % x == 0 && y <= ranks / x; ++y) {
      if (ranks / x % y != 0) continue;
      const Parts parts{x, y, ranks / x / y};
      if (!is_possible(x, 0) || !is_possible(y, 1) || !is_possible(parts[2], 2)) continue;
      if (const double work = largest_work(parts, rule); work < least) best = parts, least = work;
    }
  return best;
}

std::vector<CellBox> grid_of(const Parts& parts, const PartitionRule& rule) {
  const auto cut = [&](std::size_t axis, int part) {
    const auto units = static_cast<std::int64_t>(units_of(rule.cells[axis], axis));
    return std::min(static_cast<int>(units * part / parts[axis]) * unit_of(axis), rule.cells[axis]);
  };
  std::vector<CellBox> boxes;
  for (int k = 0; k < parts[2]; ++k)
    for (int j = 0; j < parts[1]; ++j)
      for (int i = 0; i < parts[0]; ++i) boxes.push_back({{cut(0, i), cut(1, j), cut(2, k)}, {cut(0, i + 1), cut(1, j + 1), cut(2, k + 1)}});
  return boxes;
}

struct Cut {
  std::size_t axis;
  int at;  // cell
  double cost;
};

/// The best cut across an axis, for `first` of `ranks` on its lower side; cost infinite if there is none.
Cut best_cut(const CellBox& box, std::size_t axis, int first, int ranks, const PartitionRule& rule) {
  const int unit = unit_of(axis), size = box.size(axis), units = units_of(size, axis);
  if (units < 2 || (axis == 2 && rule.keeps_columns)) return {axis, 0, std::numeric_limits<double>::infinity()};
  const double share = static_cast<double>(first) / ranks, ghosts = cost_of_ghost * 2 * rule.reach / size;
  const auto imbalance = [&](double lower, double whole) { return std::max(lower / (share * whole), (whole - lower) / ((1 - share) * whole)) - 1; };
  if (rule.load.empty()) {
    const int lower = std::clamp(static_cast<int>(std::lround(share * size / unit)), 1, units - 1) * unit;
    return {axis, box.low[axis] + lower, imbalance(lower, size) + ghosts};
  }
  const std::vector<double> costs = costs_of_layers(rule.load, box, axis);
  const double whole = std::accumulate(costs.begin(), costs.end(), 0.0);
  Cut best{axis, 0, std::numeric_limits<double>::infinity()};
  double below = 0;
  for (int layer = 0; layer < (units - 1) * unit; ++layer) {
    below += costs[static_cast<std::size_t>(layer)];
    if ((layer + 1) % unit != 0) continue;
    if (const double cost = imbalance(below, whole) + ghosts; cost < best.cost) best = {axis, box.low[axis] + layer + 1, cost};
  }
  return best;
}

/// The rule with the measured parts that have cells in the box.
PartitionRule within(const CellBox& box, PartitionRule rule) {
  std::erase_if(rule.load, [&](const MeasuredPart& part) { return intersection(part.cells, box).cells() == 0; });
  return rule;
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
  bisect(lower, first, within(lower, rule), boxes);
  bisect(upper, ranks - first, within(upper, rule), boxes);
}

/// Cells around a box that hold ghosts.
std::array<int, 3> margins(const PartitionRule& rule) { return {(rule.reach + unit_of(0) - 1) / unit_of(0) * unit_of(0), rule.reach, rule.reach}; }

}  // namespace

std::vector<CellBox> partition(const PartitionRule& rule, int ranks) {
  std::vector<CellBox> bisected;
  bisect({{0, 0, 0}, rule.cells}, ranks, rule, bisected);
  const std::optional<Parts> parts = best_parts(rule, ranks);
  if (!parts) return bisected;
  const bool is_complete = bisected.size() == static_cast<std::size_t>(ranks);
  std::vector<CellBox> regular = grid_of(*parts, rule);
  return is_complete && largest_work(bisected, rule) < largest_work(regular, rule) ? bisected : regular;
}

std::vector<CellBox> boxes_of_ranks(const PartitionRule& rule, int ranks, int first_rank) {
  const std::vector<CellBox> parts = partition(rule, ranks);
  std::vector<CellBox> boxes(static_cast<std::size_t>(ranks));
  for (std::size_t part = 0; part < parts.size(); ++part) boxes[(part + static_cast<std::size_t>(first_rank)) % boxes.size()] = parts[part];
  return boxes;
}

int count_parts(std::span<const CellBox> boxes) {
  return static_cast<int>(std::ranges::count_if(boxes, [](const CellBox& box) { return box.cells() > 0; }));
}

void RanksInTurn::add(int parts) {
  if (parts == ranks_)
    is_divided_among_all_ = true;
  else
    parts_ += parts;
}

CellBox with_ghosts(const CellBox& box, const PartitionRule& rule) {
  if (box.cells() == 0) return {{0, 0, 0}, {1, 1, 1}};
  return intersection(box.grown(margins(rule)), {{0, 0, 0}, rule.cells});
}

CellBox without_rim(const CellBox& own, const std::array<int, 3>& cells, const PartitionRule& rule) {
  CellBox interior = own;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (own.low[axis] > 0) interior.low[axis] += margins(rule)[axis];
    if (own.high[axis] < cells[axis]) interior.high[axis] -= margins(rule)[axis];
    interior.high[axis] = std::max(interior.low[axis], interior.high[axis]);
  }
  return interior;
}

std::vector<ExchangedCells> exchanged_cells(std::span<const CellBox> boxes, int rank, int reach) {
  const CellBox& own = boxes[static_cast<std::size_t>(rank)];
  const std::array<int, 3> within{reach, reach, reach};
  const CellBox around = own.grown(within);
  std::vector<ExchangedCells> exchanged;
  if (own.cells() == 0) return exchanged;
  for (std::size_t other = 0; other < boxes.size(); ++other) {
    const CellBox receive = intersection(around, boxes[other]);
    if (static_cast<int>(other) == rank || receive.cells() == 0) continue;
    exchanged.push_back({static_cast<int>(other), intersection(boxes[other].grown(within), own), receive});
  }
  return exchanged;
}

}  // namespace perimpact
