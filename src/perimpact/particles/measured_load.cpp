#include "perimpact/particles/measured_load.hpp"

namespace perimpact {

std::vector<double> numbers_of(const MeasuredLoad& load) {
  std::vector<double> numbers;
  for (const MeasuredPart& part : load) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      numbers.insert(numbers.end(), {static_cast<double>(part.cells.low[axis]), static_cast<double>(part.cells.high[axis])});
    numbers.push_back(part.cost);
  }
  return numbers;
}

MeasuredLoad load_of(std::span<const double> numbers) {
  MeasuredLoad load;
  for (; numbers.size() >= 7; numbers = numbers.subspan(7)) {
    MeasuredPart& part = load.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis)
      part.cells.low[axis] = static_cast<int>(numbers[2 * axis]), part.cells.high[axis] = static_cast<int>(numbers[2 * axis + 1]);
    part.cost = numbers[6];
  }
  return load;
}

std::vector<double> costs_of_layers(std::span<const MeasuredPart> load, const CellBox& box, std::size_t axis) {
  std::vector<double> costs(static_cast<std::size_t>(box.size(axis)), 0);
  for (const MeasuredPart& part : load) {
    const CellBox common = intersection(part.cells, box);
    if (common.cells() == 0) continue;
    const double cost = part.cost * static_cast<double>(common.cells()) / common.size(axis);
    for (int layer = common.low[axis]; layer < common.high[axis]; ++layer) costs[static_cast<std::size_t>(layer - box.low[axis])] += cost;
  }
  return costs;
}

}  // namespace perimpact
