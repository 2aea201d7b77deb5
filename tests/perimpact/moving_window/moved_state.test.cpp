#include "perimpact/moving_window/moved_state.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "perimpact/bodies.hpp"
#include "perimpact/particles/shared_numbers.hpp"

using namespace perimpact;

TEST_CASE("moved state: numbers in lists of all particles and of some move with the material, new particles keep theirs, and 0 enters from outside the list") {
  const Body body = fixtures::body({.size = {0.024, 0.008, 0.004}, .spacing = 0.001});
  const Lattice& lattice = *body.particles.lattice();
  std::vector<std::uint32_t> all(body.particles.slot_of().begin(), body.particles.slot_of().end()), middle;
  for (const std::uint32_t slot : all)
    if (const int i = lattice.cell(slot)[0]; i >= 4 && i < 20) middle.push_back(slot);
  constexpr int by = 8;
  const auto check = [&](std::span<const std::uint32_t> slots, std::size_t each) {
    const auto number = [&](std::size_t slot, std::size_t c) { return static_cast<double>(each * slot + c + 1); };
    constexpr double is_new = -1;
    std::vector<double> before, after(each * slots.size(), is_new);
    for (const std::uint32_t slot : slots)
      for (std::size_t c = 0; c < each; ++c) before.push_back(number(slot, c));
    const std::string name = "body.sea.latest_forces";
    CapturedState captured;
    captured(name, ListNumbers(std::span(before), slots));
    MovedState moved(captured, {"body", 0, 0, {-by, 0, 0}, body.particles, body.family});
    moved(name, ListNumbers(std::span(after), slots));
    std::array<std::size_t, 3> counts{};  // of new particles, of those from outside the list, and of others
    for (std::size_t k = 0; k < slots.size(); ++k) {
      const auto [i, j, l] = lattice.cell(slots[k]);
      const std::size_t from = i < by ? 0 : lattice.slot(i - by, j, l);
      const bool was_listed = i >= by && std::ranges::binary_search(slots, from);
      ++counts[i < by ? 0 : was_listed ? 2 : 1];
      for (std::size_t c = 0; c < each; ++c) REQUIRE(after[each * k + c] == (i < by ? is_new : was_listed ? number(from, c) : 0));
    }
    return counts;
  };
  for (const std::size_t each : {std::size_t{1}, std::size_t{3}}) {
    CAPTURE(each);
    const std::size_t of_column = all.size() / 24;
    CHECK(check(all, each) == std::array{8 * of_column, 0 * of_column, 16 * of_column});
    CHECK(check(middle, each) == std::array{4 * of_column, 4 * of_column, 8 * of_column});
  }
}
