#include "perimpact/particles/partition.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace perimpact {

namespace {

/// The most cells of a box, over their mean.
double imbalance(const PartitionRule& rule, int ranks) {
  std::size_t most = 0;
  for (const CellBox& box : partition(rule, ranks)) most = std::max(most, box.cells());
  return static_cast<double>(most) * ranks / static_cast<double>(CellBox{{0, 0, 0}, rule.cells}.cells());
}

/// The largest number of boxes within reach of one.
std::size_t most_neighbours(const std::vector<CellBox>& boxes, int reach) {
  std::size_t most = 0;
  for (const CellBox& box : boxes) {
    const CellBox around = box.grown({reach, reach, reach});
    const auto within = std::ranges::count_if(boxes, [&](const CellBox& other) { return intersection(around, other).cells() > 0; });
    most = std::max(most, static_cast<std::size_t>(within) - 1);
  }
  return most;
}

}  // namespace

TEST_CASE("partition: boxes of any number of ranks tile the lattice, with cuts across x at multiples of eight") {
  std::mt19937 random(19);
  const auto up_to = [&](int most) { return std::uniform_int_distribution(1, most)(random); };
  for (int trial = 0; trial < 200; ++trial) {
    const PartitionRule rule{.cells = {up_to(70), up_to(25), up_to(20)}, .reach = up_to(5), .keeps_columns = trial % 3 == 0};
    const int ranks = up_to(40);
    CAPTURE(trial);
    CAPTURE(ranks);
    const std::vector<CellBox> boxes = partition(rule, ranks);
    CHECK(boxes.size() <= static_cast<std::size_t>(ranks));
    const CellBox whole{{0, 0, 0}, rule.cells};
    std::vector<int> owners(whole.cells());
    for (const CellBox& box : boxes) {
      CHECK(box.cells() > 0);
      CHECK(intersection(box, whole) == box);
      CHECK(box.low[0] % 8 == 0);
      CHECK((box.high[0] % 8 == 0 || box.high[0] == rule.cells[0]));
      if (rule.keeps_columns) CHECK(box.size(2) == rule.cells[2]);
      for (int k = box.low[2]; k < box.high[2]; ++k)
        for (int j = box.low[1]; j < box.high[1]; ++j)
          for (int i = box.low[0]; i < box.high[0]; ++i) ++owners[static_cast<std::size_t>((k * rule.cells[1] + j) * rule.cells[0] + i)];
    }
    CHECK(std::ranges::all_of(owners, [](int count) { return count == 1; }));
  }
}

TEST_CASE("partition: every rank has a box as long as there are blocks of eight cells") {
  for (const int ranks : {1, 2, 3, 5, 6, 7, 8}) CHECK(partition({.cells = {16, 2, 2}, .reach = 3}, ranks).size() == static_cast<std::size_t>(ranks));
  CHECK(partition({.cells = {16, 2, 2}, .reach = 3}, 9).size() == 8);
}

TEST_CASE("partition: the busiest rank has at most 12 % more than the mean for 1e8 particles on 64, 1000 and 10 000 ranks, and 26 neighbours") {
  constexpr int reach = 3;
  for (const auto& cells : {std::array{464, 464, 464}, std::array{4000, 2500, 10}})
    for (const int ranks : {64, 1000, 10000}) {
      CAPTURE(cells[0]);
      CAPTURE(ranks);
      CHECK(imbalance({.cells = cells, .reach = reach}, ranks) <= 1.12);
      CHECK(most_neighbours(partition({.cells = cells, .reach = reach}, ranks), reach) <= 26);
    }
}

TEST_CASE("partition: a number of ranks without factors is bisected") { CHECK(imbalance({.cells = {464, 464, 464}, .reach = 3}, 997) < 1.17); }

}  // namespace perimpact
