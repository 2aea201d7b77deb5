#include "perimpact/device/lattice_tiles.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "fixtures/larger.hpp"

using namespace perimpact;
using namespace perimpact::device;

TEST_CASE("tiles of a lattice: each slot has one thread, and the threads of a block are in one box of 128 cells") {
  for (const std::array<int, 3> cells : {std::array{200, 100, 9}, std::array{40, 30, 1}, std::array{13, 7, 2}, std::array{176, 184, 3}, std::array{1, 1, 1},
                                         std::array{5, 1, 40}, std::array{64, 33, 4}}) {
    CAPTURE(cells[0]);
    CAPTURE(cells[2]);
    Lattice lattice;
    lattice.cells = cells;
    const LatticeTiles tiles(lattice);
    REQUIRE(tiles.slots() == lattice.slots());
    std::vector<int> visits(lattice.slots(), 0);
    for (std::size_t block = 0; block < tiles.threads() / LatticeTiles::cells; ++block) {
      std::array<int, 3> low{1 << 30, 1 << 30, 1 << 30}, high{-1, -1, -1};
      for (std::size_t n = 0; n < LatticeTiles::cells; ++n) {
        const std::size_t slot = tiles.slot(block * LatticeTiles::cells + n);
        if (slot >= lattice.slots()) continue;
        ++visits[slot];
        const std::array<int, 3> cell = lattice.cell(slot);
        for (std::size_t c = 0; c < 3; ++c) low[c] = std::min(low[c], cell[c]), high[c] = fixtures::larger(high[c], cell[c]);
      }
      if (high[0] < 0) continue;
      int box = 1;
      for (std::size_t c = 0; c < 3; ++c) box *= high[c] - low[c] + 1;
      CHECK(box <= static_cast<int>(LatticeTiles::cells));
    }
    CHECK(std::ranges::all_of(visits, [](int count) { return count == 1; }));
    CHECK(tiles.threads() % LatticeTiles::cells == 0);
  }
}
