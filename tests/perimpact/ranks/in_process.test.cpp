#include "perimpact/ranks/in_process.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>

#include "base/error.hpp"
#include "fixtures/threads.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/simulation/simulation.hpp"

using namespace perimpact;

TEST_CASE("ranks as threads: sums, largest values, gathered bytes and messages are those of all ranks") {
  for (const int size : {1, 2, 5}) {
    CAPTURE(size);
    run_in_process(size, [&](Ranks& ranks) {
      const int rank = ranks.rank();
      std::array<std::int64_t, 2> sums{rank + 1, rank == 0 ? std::numeric_limits<std::int64_t>::max() : 1};
      ranks.sum(sums);
      std::array<double, 2> most{static_cast<double>(rank), static_cast<double>(-rank)};
      ranks.max(most);
      const std::vector<int> own(static_cast<std::size_t>(rank), rank);  // none of rank 0
      const std::vector<int> all = ranks.join_all(std::span<const int>(own)), of_root = ranks.join(std::span<const int>(own));
      std::vector<int> expected;
      for (int other = 0; other < size; ++other) expected.insert(expected.end(), static_cast<std::size_t>(other), other);
      // each sends its number to the next, in a ring
      const int next = (rank + 1) % size, before = (rank + size - 1) % size;
      int received = -1;
      if (size > 1) {
        const Ranks::Outgoing send{next, std::as_bytes(std::span(&rank, 1))};
        const Ranks::Incoming receive{before, std::as_writable_bytes(std::span(&received, 1))};
        ranks.exchange(std::span(&send, 1), std::span(&receive, 1));
      }
      Ranks::Bytes bytes(ranks.is_root() ? 3 : 0, std::byte{7});
      ranks.broadcast(bytes);
      const bool any = ranks.any(rank == size - 1);

      const bool sums_agree =
          sums[0] == size * (size + 1) / 2 && sums[1] == static_cast<std::int64_t>(0x7fffffffffffffffULL + static_cast<std::uint64_t>(size - 1));
      if (!sums_agree || most[0] != size - 1 || most[1] != 0) throw fccda::RunError("sums or largest values are wrong");
      if (all != expected || of_root != (ranks.is_root() ? expected : std::vector<int>())) throw fccda::RunError("gathered bytes are wrong");
      if (size > 1 && received != before) throw fccda::RunError("a message is wrong");
      if (bytes != Ranks::Bytes(3, std::byte{7}) || !any) throw fccda::RunError("the bytes of the root are wrong");
    });
  }
}

TEST_CASE("ranks as threads: where one rank fails, the others fail in their next collective call, and its error is that of the run") {
  const auto fails = [](Ranks& ranks) {
    if (ranks.rank() == 1) throw fccda::InputError("rank 1 cannot read its file");
    for (;;) ranks.any(false);
  };
  CHECK_THROWS_WITH_AS(run_in_process(3, fails), "rank 1 cannot read its file", fccda::InputError);
}

TEST_CASE("ranks as threads: messages of unequal length are refused") {
  const auto disagree = [](Ranks& ranks) {
    std::array<int, 2> values{};
    const Ranks::Outgoing send{1 - ranks.rank(), std::as_bytes(std::span(values))};
    const Ranks::Incoming receive{1 - ranks.rank(), std::as_writable_bytes(std::span(values).first(1))};
    ranks.exchange(std::span(&send, 1), std::span(&receive, 1));
  };
  CHECK_THROWS_WITH_AS(run_in_process(2, disagree), "ranks disagree about the messages between them", fccda::RunError);
}

TEST_CASE("ranks as threads: three ranks of two threads end in the state of one rank") {
  Setup setup;
  setup.time = {.end = 4e-6, .step = 2e-7};
  setup.bodies = {fixtures::body_setup({.size = {0.034, 0.012, 0.008}, .spacing = 0.002, .poissons_ratio = 0.3, .critical_stretch = 5e-4})};
  ImpactorSetup ball;
  ball.name = "ball";
  ball.surface = SphereSurface{.diameter = 0.01, .edge_length = 0.002};
  ball.mass = 0.01;
  ball.position = {0, 0.0111, 0};
  ball.velocity = {0, -100, 0};
  ball.free_dofs = {"y"};
  setup.impactors = {ball};
  const auto hash_of = [&](int size) {
    std::uint64_t hash = 0;
    run_in_process(size, [&](Ranks& ranks) {
      Simulation simulation(setup, {}, ranks);
      while (!simulation.clock().is_finished()) simulation.step();
      const std::uint64_t of_run = simulation.state_hash();
      if (ranks.is_root()) hash = of_run;
    });
    return hash;
  };
  const std::uint64_t one = hash_of(1);
  const fixtures::Threads with_two(2);
  CHECK(hash_of(3) == one);
}
