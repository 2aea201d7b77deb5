// Every process checks the collective calls with messages larger than the parts in which they travel, and prints what differs. Exit code: 0 if nothing.
//
//   mpirun -n 3 ranks_mpi_processes
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <vector>

#include "ranks_mpi/mpi_ranks.hpp"

namespace {

using namespace perimpact;

int failures = 0;

void expect(bool is_true, const char* claim, int rank) {
  if (is_true) return;
  ++failures;
  std::printf("rank %d: %s\n", rank, claim);
}

/// Bytes that tell from which rank they are, of a length that tells too: from less than a part to several.
Ranks::Bytes bytes_of(int rank, int to = 0) {
  Ranks::Bytes bytes(static_cast<std::size_t>(5 + 37 * rank + to));
  for (std::size_t at = 0; at < bytes.size(); ++at) bytes[at] = static_cast<std::byte>(31 * rank + 7 * to + static_cast<int>(at));
  return bytes;
}

void check(Ranks& ranks) {
  const int rank = ranks.rank(), size = ranks.size();
  std::vector<Ranks::Bytes> sent, received;
  std::vector<Ranks::Outgoing> outgoing;
  std::vector<Ranks::Incoming> incoming;
  for (int other = 0; other < size; ++other) {
    sent.push_back(bytes_of(rank, other));
    received.emplace_back(bytes_of(other, rank).size());
  }
  for (int other = 0; other < size; ++other)
    if (other != rank) {
      outgoing.push_back({other, sent[static_cast<std::size_t>(other)]});
      incoming.push_back({other, received[static_cast<std::size_t>(other)]});
    }
  ranks.exchange(outgoing, incoming);
  for (const Ranks::Incoming& message : incoming)
    expect(received[static_cast<std::size_t>(message.from)] == bytes_of(message.from, rank), "exchange: a message arrives as it was sent", rank);

  std::vector<std::int64_t> sums(100);
  std::iota(sums.begin(), sums.end(), std::int64_t{rank});
  sums.back() = INT64_MAX;
  ranks.sum(sums);
  bool is_sum = true;
  for (std::int64_t k = 0; k < 99; ++k) is_sum = is_sum && sums[static_cast<std::size_t>(k)] == size * k + size * (size - 1) / 2;
  expect(is_sum, "sum: each of the values is summed over the ranks", rank);
  expect(sums.back() == static_cast<std::int64_t>(static_cast<std::uint64_t>(INT64_MAX) * static_cast<std::uint64_t>(size)), "sum: integers wrap", rank);

  std::vector<double> largest(50, -1.5 - rank);
  ranks.max(largest);
  expect(largest == std::vector<double>(50, -1.5), "max: each of the values is the largest of all ranks", rank);
  expect(ranks.any(rank == size - 1) && !ranks.any(false), "any: true if it is on one rank", rank);

  std::vector<Ranks::Bytes> expected;
  for (int other = 0; other < size; ++other) expected.push_back(bytes_of(other));
  expect(ranks.gather_all(bytes_of(rank)) == expected, "gather_all: the bytes of all ranks on every one", rank);
  expect(ranks.gather(bytes_of(rank)) == (rank == 0 ? expected : std::vector<Ranks::Bytes>()), "gather: the bytes of all ranks on the root", rank);
  expect(ranks.gather_all({}) == std::vector<Ranks::Bytes>(static_cast<std::size_t>(size)), "gather_all: nothing of all ranks", rank);

  Ranks::Bytes bytes = bytes_of(rank + 9);
  ranks.broadcast(bytes);
  expect(bytes == bytes_of(9), "broadcast: the bytes of the root, whatever length they had here", rank);
}

}  // namespace

int main() {
  {
    constexpr std::size_t chunk = 16;
    MpiRanks ranks(chunk);
    check(ranks);
    expect(ranks.all_arrive(60), "all_arrive: all ranks arrive", ranks.rank());
    if (ranks.is_root()) std::printf("%d ranks\n", ranks.size());
  }
  return failures == 0 ? 0 : 1;
}
