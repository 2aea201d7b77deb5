#include "perimpact/particles/partition.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "fixtures/larger.hpp"
#include "perimpact/particles/cloud_part.hpp"

using namespace perimpact;

namespace {

/// The most cells of a box, over their mean.
double imbalance(const PartitionRule& rule, int ranks) {
  std::size_t most = 0;
  for (const CellBox& box : partition(rule, ranks)) most = fixtures::larger(most, box.cells());
  return static_cast<double>(most) * ranks / static_cast<double>(CellBox{{0, 0, 0}, rule.cells}.cells());
}

/// The largest cost of a box, over their mean.
double imbalance_of_costs(const std::vector<CellBox>& boxes, const MeasuredLoad& load) {
  double most = 0, all = 0;
  for (const CellBox& box : boxes) most = fixtures::larger(most, cost_of(load, box)), all += cost_of(load, box);
  return most * static_cast<double>(boxes.size()) / all;
}

/// The largest number of boxes within reach of one.
std::size_t most_neighbours(const std::vector<CellBox>& boxes, int reach) {
  std::size_t most = 0;
  for (const CellBox& box : boxes) {
    const CellBox around = box.grown({reach, reach, reach});
    const auto within = std::ranges::count_if(boxes, [&](const CellBox& other) { return intersection(around, other).cells() > 0; });
    most = fixtures::larger(most, static_cast<std::size_t>(within) - 1);
  }
  return most;
}

}  // namespace

TEST_CASE("partition: boxes of any number of ranks tile the lattice, with cuts across x at multiples of eight") {
  std::mt19937 random(19);
  const auto up_to = [&](int most) { return std::uniform_int_distribution(1, most)(random); };
  for (int trial = 0; trial < 200; ++trial) {
    PartitionRule rule{.cells = {up_to(70), up_to(25), up_to(20)}, .reach = up_to(5), .keeps_columns = trial % 3 == 0};
    if (trial % 2 == 0)
      for (const CellBox& box : partition(rule, up_to(10))) rule.load.push_back({box, static_cast<double>(up_to(100))});
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

TEST_CASE("partition: cells that cost a quarter more or four times as much as others are divided by the costs that were measured") {
  const PartitionRule equal{.cells = {160, 90, 40}, .reach = 3};
  for (const double factor : {1.25, 4.0})
    for (const int measured : {2, 8})
      for (const int ranks : {2, 3, 4, 8, 16}) {
        CAPTURE(factor);
        CAPTURE(measured);
        CAPTURE(ranks);
        PartitionRule rule = equal;
        for (const CellBox& box : partition(equal, measured)) rule.load.push_back({box, rule.load.empty() ? 1e-6 * factor : 1e-6});
        // a cut is between layers, in x of eight cells: of a part of a sixteenth of the cells, a twelfth
        CHECK(imbalance_of_costs(partition(rule, ranks), rule.load) < 1.12);
        if (factor == 4 && ranks == measured) CHECK(imbalance_of_costs(partition(equal, ranks), rule.load) > 1.5);
      }
}

TEST_CASE("partition: the ranges of a cloud cost the same to one eight of points, and every rank has one as long as there are eights") {
  for (const std::size_t eights : {5u, 64u, 1000u})
    for (const int ranks : {2, 5, 16}) {
      CAPTURE(eights);
      CAPTURE(ranks);
      const int third = static_cast<int>(eights / 3);
      const MeasuredLoad load{{{{0, 0, 0}, {third, 1, 1}}, 5}, {{{third, 0, 0}, {static_cast<int>(eights), 1, 1}}, 1}};
      const CloudPartition partition(eights, ranks, 0, load);
      REQUIRE(partition.parts() == std::min(ranks, static_cast<int>(eights)));
      const double mean = cost_of(load, {{0, 0, 0}, {static_cast<int>(eights), 1, 1}}) / partition.parts();
      for (int part = 0; part < partition.parts(); ++part) {
        CHECK(partition.end(part) > partition.begin(part));
        const CellBox range{{static_cast<int>(partition.begin(part)), 0, 0}, {static_cast<int>(partition.end(part)), 1, 1}};
        if (eights >= 64) CHECK(std::abs(cost_of(load, range) - mean) <= 5);  // an eight of the costly third
      }
    }
}

TEST_CASE("partition: a measured load is restored from its numbers") {
  const MeasuredLoad load{{{{0, 8, 1}, {16, 9, 4}}, 3e-7}, {{{16, 8, 1}, {24, 9, 4}}, 1e-6}};
  const MeasuredLoad restored = load_of(numbers_of(load));
  REQUIRE(restored.size() == 2);
  for (std::size_t part = 0; part < 2; ++part) {
    CHECK(restored[part].cells == load[part].cells);
    CHECK(restored[part].cost == load[part].cost);
  }
}
