#include "perimpact/particles/share.hpp"

#include <doctest/doctest.h>

#include <mutex>

#include "base/error.hpp"
#include "perimpact/ranks/in_process.hpp"

using namespace perimpact;

namespace {

struct Scene {
  std::array<int, 3> cells;
  int ranks, reach;
};
const Scene scenes[] = {{{37, 11, 9}, 2, 3}, {{37, 11, 9}, 3, 3}, {{64, 20, 1}, 7, 3}, {{16, 40, 40}, 8, 4}, {{70, 5, 5}, 5, 3}, {{9, 9, 33}, 4, 2}};

Lattice lattice_of(const Scene& scene) {
  Lattice lattice{.cells = scene.cells, .spacing = 0.5, .origin = {1, 2, 3}};
  if (scene.cells[2] == 1) lattice.thickness = 0.1;
  return lattice;
}

/// A number that only this slot of the whole lattice has.
double number_of(std::size_t whole_slot) { return 1e6 + static_cast<double>(whole_slot); }

}  // namespace

TEST_CASE("share: each cell is owned by one rank, and a cell of a rank has the centre that it has on the whole lattice, to the bit") {
  for (const Scene& scene : scenes) {
    const Lattice whole = lattice_of(scene);
    std::vector<int> owners(whole.slots(), 0);
    std::mutex mutex;
    bool centres_agree = true;
    run_in_process(scene.ranks, [&](Ranks& ranks) {
      const Share share(ranks, whole, PartitionRule{whole.cells, scene.reach});
      const Lattice own = share.lattice();
      const std::lock_guard guard(mutex);
      for (std::size_t slot = 0; slot < own.slots(); ++slot) {
        const auto [i, j, k] = own.cell(slot);
        if (!own.contains(i, j, k)) continue;
        const std::size_t of_whole = share.whole_slot(slot);
        centres_agree = centres_agree && own.centre(slot) == whole.centre(of_whole);
        if (share.owned_cells().contains({i, j, k})) ++owners[of_whole];
        CHECK((share.owned_slot(of_whole) == slot) == share.owned_cells().contains({i, j, k}));
      }
    });
    CHECK(centres_agree);
    for (std::size_t slot = 0; slot < owners.size(); ++slot) {
      const auto [i, j, k] = whole.cell(slot);
      CHECK(owners[slot] == (whole.contains(i, j, k) ? 1 : 0));
    }
  }
}

TEST_CASE("share: after a refresh every cell within reach of an owned one has the value of its owner, and no other cell has changed") {
  for (const Scene& scene : scenes) {
    const Lattice whole = lattice_of(scene);
    std::mutex mutex;
    run_in_process(scene.ranks, [&](Ranks& ranks) {
      const Share share(ranks, whole, PartitionRule{whole.cells, scene.reach});
      const Lattice own = share.lattice();
      constexpr double stale = -1;
      std::vector<double> values(own.slots(), stale), twice = values;
      for (std::size_t slot = 0; slot < own.slots(); ++slot)
        if (share.owned_cells().contains(own.cell(slot))) values[slot] = number_of(share.whole_slot(slot)), twice[slot] = 2 * values[slot];
      share.refresh({values.data(), twice.data()});
      const CellBox near = share.owned_cells().grown({scene.reach, scene.reach, whole.thickness ? 0 : scene.reach});
      std::size_t refreshed = 0;
      const std::lock_guard guard(mutex);
      for (std::size_t slot = 0; slot < own.slots(); ++slot) {
        const std::array<int, 3> cell = own.cell(slot);
        if (!own.contains(cell[0], cell[1], cell[2])) continue;
        const double expected = near.contains(cell) ? number_of(share.whole_slot(slot)) : stale;
        CHECK(values[slot] == expected);
        CHECK(twice[slot] == (expected == stale ? stale : 2 * expected));
        if (near.contains(cell) && !share.owned_cells().contains(cell)) ++refreshed;
      }
      CHECK(share.ghosts() == refreshed);
    });
  }
}

TEST_CASE("share: flags that a rank sets for its ghosts reach their owners, who keep their own") {
  for (const Scene& scene : scenes) {
    const Lattice whole = lattice_of(scene);
    std::vector<std::uint8_t> wanted(whole.slots(), 0), found(whole.slots(), 0);
    std::mutex mutex;
    run_in_process(scene.ranks, [&](Ranks& ranks) {
      const Share share(ranks, whole, PartitionRule{whole.cells, scene.reach});
      std::vector<std::uint8_t> flags(share.lattice().slots(), 0);
      std::vector<std::size_t> set;
      share.for_each_ghost([&](std::size_t slot) {
        if (share.whole_slot(slot) % 5 == 0) flags[slot] = 1, set.push_back(slot);
      });
      for (std::size_t slot = 0; slot < flags.size(); ++slot)
        if (share.owned_cells().contains(share.lattice().cell(slot)) && share.whole_slot(slot) % 7 == 0) flags[slot] = 1, set.push_back(slot);
      share.collect_flags(flags.data());
      const std::lock_guard guard(mutex);
      for (const std::size_t slot : set) wanted[share.whole_slot(slot)] = 1;
      for (std::size_t slot = 0; slot < flags.size(); ++slot)
        if (share.owned_cells().contains(share.lattice().cell(slot))) found[share.whole_slot(slot)] = flags[slot];
    });
    CHECK(found == wanted);
  }
}

TEST_CASE("share: numbers of the eights of the body are gathered in order, and each rank takes its own from them, of ghosts those by slot") {
  for (const Scene& scene : scenes)
    for (const std::size_t per_eight : {std::size_t{1}, std::size_t{8}, std::size_t{11}}) {
      const Lattice whole = lattice_of(scene);
      std::mutex mutex;
      run_in_process(scene.ranks, [&](Ranks& ranks) {
        const Share share(ranks, whole, PartitionRule{whole.cells, scene.reach});
        const std::size_t eights = share.lattice().slots() / 8;
        std::vector<double> own(eights * per_eight, -1);
        const auto number = [&](std::size_t eight, std::size_t n) { return number_of(share.whole_slot(8 * eight) / 8 * per_eight + n); };
        for (std::size_t eight = 0; eight < eights; ++eight)
          if (share.owned_cells().contains(share.lattice().cell(8 * eight)))
            for (std::size_t n = 0; n < per_eight; ++n) own[eight * per_eight + n] = number(eight, n);
        const std::vector<double> gathered = share.gather(std::span<const double>(own), {.each = per_eight});
        std::vector<double> expected;
        for (std::size_t n = 0; n < whole.slots() / 8 * per_eight; ++n) expected.push_back(number_of(n));
        std::vector<double> taken(own.size(), -1);
        share.take(std::span<const double>(ranks.is_root() ? expected : std::vector<double>()), std::span<double>(taken), {.each = per_eight});
        const std::lock_guard guard(mutex);
        CHECK(gathered == (ranks.is_root() ? expected : std::vector<double>()));
        bool agree = true;
        for (std::size_t eight = 0; eight < eights; ++eight) {
          const bool is_set = per_eight == 8 || share.owned_cells().contains(share.lattice().cell(8 * eight));
          for (std::size_t n = 0; n < per_eight; ++n) agree = agree && taken[eight * per_eight + n] == (is_set ? number(eight, n) : 0);
        }
        CHECK(agree);
      });
    }
}

TEST_CASE("share: numbers of listed particles are gathered by their slots in the whole body, whichever ranks have them, the root or only others") {
  const Lattice whole = lattice_of(scenes[0]);
  for (const bool only_on_last : {false, true}) {
    CAPTURE(only_on_last);
    std::vector<double> expected;
    std::size_t of_root = 0;
    std::mutex mutex;
    const auto is_listed = [&](const Share& share, std::size_t slot) { return slot % 11 == 0 && (!only_on_last || share.owner_of(slot) == 2); };
    run_in_process(3, [&](Ranks& ranks) {
      const Share share(ranks, whole, PartitionRule{whole.cells, 3});
      std::vector<std::uint32_t> slots;
      std::vector<double> own;  // two of each
      for (std::size_t slot = 0; slot < share.lattice().slots(); ++slot)
        if (share.owned_cells().contains(share.lattice().cell(slot)) && is_listed(share, share.whole_slot(slot))) {
          slots.push_back(static_cast<std::uint32_t>(slot));
          own.insert(own.end(), {number_of(share.whole_slot(slot)), -number_of(share.whole_slot(slot))});
        }
      const std::vector<double> gathered = share.gather_listed(std::span<const double>(own), slots);
      std::vector<double> in_order;
      for (std::size_t slot = 0; slot < whole.slots(); ++slot) {
        const auto [i, j, k] = whole.cell(slot);
        if (whole.contains(i, j, k) && is_listed(share, slot)) in_order.insert(in_order.end(), {number_of(slot), -number_of(slot)});
      }
      std::vector<double> taken(own.size(), 0);
      share.take_listed(std::span<const double>(ranks.is_root() ? in_order : std::vector<double>()), std::span<double>(taken), slots);
      const std::lock_guard guard(mutex);
      CHECK(gathered == (ranks.is_root() ? in_order : std::vector<double>()));
      CHECK(taken == own);
      if (ranks.is_root()) expected = in_order, of_root = own.size();
    });
    CHECK(expected.size() > 10);
    CHECK((of_root == 0) == only_on_last);
  }
}

TEST_CASE("share: a shift takes the numbers of the cells further on from whichever rank has them, and keeps those whose cells would be outside the body") {
  const Lattice whole{.cells = {64, 12, 9}, .spacing = 0.5};
  for (const int count : {1, 2, 3, 7})
    for (const std::array<int, 3> by : {std::array{8, 0, 0}, std::array{-24, 0, 0}, std::array{0, 5, 0}, std::array{16, -8, 2}, std::array{72, 0, 0}})
      for (const std::size_t per_eight : {std::size_t{1}, std::size_t{8}, std::size_t{5}}) {
        CAPTURE(count);
        CAPTURE(per_eight);
        run_in_process(count, [&](Ranks& ranks) {
          const Share share(ranks, whole, PartitionRule{whole.cells, 3});
          const Lattice lattice = share.is_whole() ? whole : share.lattice();
          const auto number = [&](std::size_t whole_eight, std::size_t n) { return number_of(whole_eight * per_eight + n); };
          const auto owns = [&](std::size_t eight) { return share.is_whole() || share.owned_cells().contains(lattice.cell(8 * eight)); };
          std::vector<double> before(lattice.slots() / 8 * per_eight, -1), after(before.size(), -2), expected = after;
          for (std::size_t eight = 0; eight < lattice.slots() / 8; ++eight) {
            if (!owns(eight)) continue;
            const std::size_t of_whole = share.whole_slot(8 * eight) / 8;
            std::array<int, 3> cell = whole.cell(8 * of_whole);
            for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] += by[axis];
            const bool is_inside = whole.contains(cell[0], cell[1], cell[2]);
            for (std::size_t n = 0; n < per_eight; ++n) {
              before[eight * per_eight + n] = number(of_whole, n);
              if (is_inside) expected[eight * per_eight + n] = number(whole.slot(cell[0], cell[1], cell[2]) / 8, n);
            }
          }
          share.shift(lattice, std::span<const double>(before), std::span<double>(after), per_eight, by);
          CHECK(after == expected);
        });
      }
}

TEST_CASE("share: columns are kept whole on request, and a body of few blocks of cells is divided among that many ranks, from the first given one on") {
  const Lattice sheet{.cells = {16, 12, 8}, .spacing = 1};
  run_in_process(4, [&](Ranks& ranks) { REQUIRE(Share(ranks, sheet, PartitionRule{sheet.cells, 3, true}).owned_cells().size(2) == 8); });
  const Lattice small{.cells = {8, 2, 1}, .spacing = 1};
  run_in_process(4, [&](Ranks& ranks) {
    const Share share(ranks, small, PartitionRule{small.cells, 1}, 3);
    REQUIRE(share.parts() == 2);
    const bool is_owner = ranks.rank() == 3 || ranks.rank() == 0;
    REQUIRE(share.owned_cells().cells() == (is_owner ? 8 : 0));
    REQUIRE(share.peers() == (is_owner ? 1 : 0));
    REQUIRE(share.owner_of(0) == 3);
    REQUIRE(share.owner_of(8) == 0);
    std::vector<double> values(share.lattice().slots(), ranks.rank());
    share.refresh({values.data()});
    const std::vector<double> gathered = share.gather(std::span<const double>(values), {.each = 8});
    if (ranks.is_root()) REQUIRE(gathered == std::vector<double>{3, 3, 3, 3, 3, 3, 3, 3, 0, 0, 0, 0, 0, 0, 0, 0});
  });
}
