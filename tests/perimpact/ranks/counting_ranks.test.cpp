#include "perimpact/ranks/counting_ranks.hpp"

#include <doctest/doctest.h>

#include <array>
#include <mutex>
#include <thread>

#include "fixtures/tolerance.hpp"
#include "perimpact/ranks/delayed_ranks.hpp"
#include "perimpact/ranks/in_process.hpp"

using namespace perimpact;

TEST_CASE("counting ranks: messages, reductions and collections are counted with the bytes of this rank, and calls have the results of the ranks inside") {
  std::mutex mutex;
  run_in_process(3, [&](Ranks& inner) {
    CountingRanks ranks(inner);
    const int next = (ranks.rank() + 1) % 3, before = (ranks.rank() + 2) % 3;
    const std::array<int, 5> sent{ranks.rank(), 1, 2, 3, 4};
    std::array<int, 5> received{};
    const Ranks::Outgoing send{next, std::as_bytes(std::span(sent))};
    const Ranks::Incoming receive{before, std::as_writable_bytes(std::span(received))};
    for (int twice = 0; twice < 2; ++twice) ranks.exchange(std::span(&send, 1), std::span(&receive, 1));
    std::array<std::int64_t, 4> sums{1, 2, 3, ranks.rank()};
    ranks.sum(sums);
    const bool any = ranks.any(ranks.rank() == 2);
    const std::vector<char> own(static_cast<std::size_t>(ranks.rank()), 'a');
    const std::vector<char> all = ranks.join_all(std::span<const char>(own)), of_root = ranks.join(std::span<const char>(own));
    Ranks::Bytes bytes(ranks.is_root() ? 7 : 0, std::byte{3});
    ranks.broadcast(bytes);
    const Traffic traffic = ranks.traffic();
    const std::lock_guard guard(mutex);
    CHECK(received[0] == before);
    CHECK(sums == std::array<std::int64_t, 4>{3, 6, 9, 3});
    CHECK(any);
    CHECK(all.size() == 3);
    CHECK(of_root.size() == (ranks.is_root() ? 3 : 0));
    CHECK(bytes == Ranks::Bytes(7, std::byte{3}));
    CHECK(traffic.messages == 2);
    CHECK(traffic.bytes == 40);
    CHECK(traffic.reductions == 2);
    CHECK(traffic.reduced_bytes == 40);
    CHECK(traffic.collections == 3);
    CHECK(traffic.collected_bytes == 2 * ranks.rank() + (ranks.is_root() ? 7 : 0));
  });
}

TEST_CASE("counting ranks: the time in calls includes the wait for a late rank") {
  constexpr std::chrono::milliseconds late(50);
  std::mutex mutex;
  run_in_process(2, [&](Ranks& inner) {
    CountingRanks ranks(inner);
    if (ranks.rank() == 1) std::this_thread::sleep_for(late);
    ranks.any(false);
    const std::lock_guard guard(mutex);
    if (ranks.is_root()) CHECK(ranks.traffic().seconds > 0.5 * std::chrono::duration<double>(late).count());
  });
}

TEST_CASE("delayed ranks: calls take the time of their messages longer, and have the results of the ranks inside") {
  const Network network{.latency = 2e-3, .bandwidth = 1e3};
  std::mutex mutex;
  run_in_process(3, [&](Ranks& inner) {
    DelayedRanks delayed(inner, network);
    CountingRanks ranks(delayed);
    const std::array<std::int64_t, 2> own{ranks.rank(), 1};
    std::array<std::int64_t, 2> sums = own;
    ranks.sum(sums);
    const std::vector<std::int64_t> all = ranks.join_all(std::span<const std::int64_t>(own));
    const std::lock_guard guard(mutex);
    CHECK(sums == std::array<std::int64_t, 2>{3, 3});
    CHECK(all == std::vector<std::int64_t>{0, 1, 1, 1, 2, 1});
    // two levels of two calls with 16 bytes each: 4 latencies, and 64 bytes
    CHECK(network.seconds_of(ranks.traffic(), 3) == fixtures::relative(4 * 2e-3 + 64e-3, 1e-12));
    CHECK(ranks.traffic().seconds >= 4 * 2e-3 + 64e-3);
  });
}
