#include "perimpact/moving_window/moved_state.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "perimpact/bodies.hpp"
#include "perimpact/particles/shared_numbers.hpp"

using namespace perimpact;

TEST_CASE("moved state: lists of one and of three numbers of each particle move with the material, those of some particles stay") {
  const Body body = fixtures::body({.size = {0.024, 0.008, 0.004}, .spacing = 0.001});
  const Lattice& lattice = *body.particles.lattice();
  const std::span<const std::uint32_t> all = body.particles.slot_of(), some = all.subspan(0, all.size() / 2);
  constexpr int by = 8;
  const auto moves = [&](std::span<const std::uint32_t> slots, std::size_t each) {
    const auto number = [&](std::size_t slot, std::size_t c) { return static_cast<double>(each * slot + c); };
    constexpr double is_new = -1;
    std::vector<double> before, after(each * slots.size(), is_new);
    for (const std::uint32_t slot : slots)
      for (std::size_t c = 0; c < each; ++c) before.push_back(number(slot, c));
    const std::string name = "body.sea.latest_forces";
    CapturedState captured;
    captured(name, ListNumbers(std::span(before), slots));
    MovedState moved(captured, {"body", 0, 0, {-by, 0, 0}, body.particles, body.family});
    moved(name, ListNumbers(std::span(after), slots));
    if (after == before) return false;
    for (std::size_t k = 0; k < slots.size(); ++k) {
      const auto [i, j, l] = lattice.cell(slots[k]);
      for (std::size_t c = 0; c < each; ++c) REQUIRE(after[each * k + c] == (i < by ? is_new : number(lattice.slot(i - by, j, l), c)));
    }
    return true;
  };
  CHECK(moves(all, 1));
  CHECK(moves(all, 3));
  CHECK(!moves(some, 3));
}
