#include "perimpact/self_contact/wrapped_cells.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace perimpact;

namespace {
VectorArray array_of(const std::vector<Vec3d>& points) {
  VectorArray array(points.size(), 0);
  for (std::size_t p = 0; p < points.size(); ++p) array.set(p, points[p]);
  return array;
}
}  // namespace

TEST_CASE(
    "wrapped cells: the cell and its neighbours contain all points within an edge, two rings all within two edges, each once, and of those to consider, on "
    "lines, in planes and with distant points") {
  std::mt19937_64 random(5);
  struct Scene {
    const char* name;
    Vec3d size;
    int far_away;
  };
  for (const Scene& scene : {Scene{"space", {1, 2, 0.3}, 0}, Scene{"plane", {1, 1, 0}, 0}, Scene{"line", {0, 4, 0}, 0}, Scene{"debris", {1, 1, 1}, 20},
                             Scene{"one place", {0, 0, 0}, 0}}) {
    CAPTURE(scene.name);
    std::vector<Vec3d> points;
    std::uniform_real_distribution<double> part(0, 1), way(-1e4, 1e4);
    for (int p = 0; p < 400; ++p) points.push_back({scene.size.x * part(random), scene.size.y * part(random), -7 + scene.size.z * part(random)});
    for (int p = 0; p < scene.far_away; ++p) points.push_back({way(random), way(random), way(random)});
    const double edge = 0.11;
    WrappedCells cells;
    cells.sort(array_of(points), edge);
    CHECK(cells.size() <= 2 * points.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
      std::vector<std::uint32_t> found, even;  // all, and those in even places of the order of cells
      std::set<std::size_t> visited;
      cells.for_each_around(cells.cell_of(p), [&](std::size_t cell) {
        REQUIRE(visited.insert(cell).second);
        const auto all = [](std::size_t) { return ~0u; };
        const auto in_even_places = [](std::size_t first) { return first % 2 == 0 ? 0x55555555u : 0xaaaaaaaau; };
        cells.for_each_within(cell, points[p], edge * edge, all, [&](std::uint32_t q) { found.push_back(q); });
        cells.for_each_within(cell, points[p], edge * edge, in_even_places, [&](std::uint32_t q) { even.push_back(q); });
      });
      std::size_t missed = 0;
      for (std::size_t place = 0; place < points.size(); ++place) {
        const std::uint32_t q = cells.points_by_cell()[place];
        const bool is_within = norm(points[q] - points[p]) < edge;
        if (std::ranges::count(found, q) != is_within) ++missed;
        if (std::ranges::count(even, q) != (is_within && place % 2 == 0)) ++missed;
      }
      visited.clear(), found.clear();
      const auto visit = [&](std::size_t cell) {
        REQUIRE(visited.insert(cell).second);
        cells.for_each_within(
            cell, points[p], 4 * edge * edge, [](std::size_t) { return ~0u; }, [&](std::uint32_t q) { found.push_back(q); });
      };
      cells.for_each_around(cells.cell_of(p), visit, 2);
      for (std::uint32_t q = 0; q < points.size(); ++q) missed += std::ranges::count(found, q) != (norm(points[q] - points[p]) < 2 * edge);
      REQUIRE(missed == 0);
    }
  }
}

TEST_CASE("wrapped cells: NaN positions are harmless") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), far = std::numeric_limits<double>::infinity();
  WrappedCells cells;
  cells.sort(array_of({{0, 0, 0}, {nan, 0, 1}, {far, -far, 1e300}}), 0.1);
  std::size_t points = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) points += cells.points_in(cell).size();
  CHECK(points == 3);
}
