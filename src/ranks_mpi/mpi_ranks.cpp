#include "ranks_mpi/mpi_ranks.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "base/error.hpp"

namespace perimpact {

// An error in a call ends all ranks with the message of MPI: its default, MPI_ERRORS_ARE_FATAL.

MpiRanks::MpiRanks(std::size_t chunk) : chunk_(chunk) {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  if (provided < MPI_THREAD_FUNNELED) {
    MPI_Finalize();
    throw fccda::InputError("this MPI library does not support threads (MPI_THREAD_FUNNELED), with which forces are computed; use one that does.");
  }
  MPI_Comm_dup(MPI_COMM_WORLD, &world_);
  MPI_Comm_dup(MPI_COMM_WORLD, &last_);
  MPI_Comm_rank(world_, &rank_);
  MPI_Comm_size(world_, &size_);
}

MpiRanks::~MpiRanks() { MPI_Finalize(); }

std::unique_ptr<Ranks::Exchange> MpiRanks::begin_exchange(std::span<const Outgoing> send, std::span<const Incoming> receive) {
  struct Requests final : Exchange {
    void complete() override { MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE); }
    std::vector<MPI_Request> requests;
  };
  constexpr int tag = 0;  // messages between two ranks, and their parts, are received in the order in which they are sent
  auto exchange = std::make_unique<Requests>();
  std::vector<MPI_Request>& requests = exchange->requests;
  const auto for_each_part = [this](std::size_t bytes, const auto& pass) {
    for (std::size_t begin = 0; begin < bytes; begin += chunk_) pass(begin, static_cast<int>(std::min(chunk_, bytes - begin)));
  };
  for (const Incoming& message : receive)
    for_each_part(message.bytes.size(), [&](std::size_t begin, int count) {
      MPI_Irecv(message.bytes.data() + begin, count, MPI_BYTE, message.from, tag, world_, &requests.emplace_back());
    });
  for (const Outgoing& message : send)
    for_each_part(message.bytes.size(), [&](std::size_t begin, int count) {
      MPI_Isend(message.bytes.data() + begin, count, MPI_BYTE, message.to, tag, world_, &requests.emplace_back());
    });
  return exchange;
}

template <class T>
void MpiRanks::combine(std::span<T> values, MPI_Datatype type, MPI_Op operation) const {
  const std::size_t most = chunk_ / sizeof(T);
  for (std::size_t begin = 0; begin < values.size(); begin += most)
    MPI_Allreduce(MPI_IN_PLACE, values.data() + begin, static_cast<int>(std::min(most, values.size() - begin)), type, operation, world_);
}

void MpiRanks::sum(std::span<std::int64_t> values) { combine(values, MPI_UINT64_T, MPI_SUM); }  // unsigned integers wrap

void MpiRanks::max(std::span<double> values) { combine(values, MPI_DOUBLE, MPI_MAX); }

std::vector<std::int64_t> MpiRanks::sizes_of_all(std::size_t own) const {
  const auto size = static_cast<std::int64_t>(own);
  std::vector<std::int64_t> sizes(static_cast<std::size_t>(size_));
  MPI_Allgather(&size, 1, MPI_INT64_T, sizes.data(), 1, MPI_INT64_T, world_);
  return sizes;
}

std::vector<Ranks::Bytes> MpiRanks::gather_all(std::span<const std::byte> bytes) {
  const std::vector<std::int64_t> sizes = sizes_of_all(bytes.size());
  std::vector<int> counts, begins;
  std::size_t total = 0;
  for (const std::int64_t size : sizes) {
    begins.push_back(static_cast<int>(std::min(total, chunk_)));
    counts.push_back(static_cast<int>(std::min(static_cast<std::size_t>(size), chunk_)));
    total += static_cast<std::size_t>(size);
  }
  std::vector<Bytes> all;
  if (total <= chunk_) {
    Bytes joined(total);
    MPI_Allgatherv(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, joined.data(), counts.data(), begins.data(), MPI_BYTE, world_);
    for (std::size_t from = 0; from < sizes.size(); ++from) all.emplace_back(joined.begin() + begins[from], joined.begin() + begins[from] + counts[from]);
  } else {
    for (int from = 0; from < size_; ++from) {
      Bytes& of_rank = all.emplace_back(static_cast<std::size_t>(sizes[static_cast<std::size_t>(from)]));
      if (from == rank_) std::ranges::copy(bytes, of_rank.begin());
      broadcast(of_rank, from);
    }
  }
  return all;
}

std::vector<Ranks::Bytes> MpiRanks::gather(std::span<const std::byte> bytes) {
  const std::vector<std::int64_t> sizes = sizes_of_all(bytes.size());
  if (!is_root()) {
    const Outgoing own{0, bytes};
    exchange({&own, 1}, {});
    return {};
  }
  std::vector<Bytes> all;
  for (const std::int64_t size : sizes) all.emplace_back(static_cast<std::size_t>(size));
  std::ranges::copy(bytes, all.front().begin());
  std::vector<Incoming> incoming;
  for (int from = 1; from < size_; ++from) incoming.push_back({from, all[static_cast<std::size_t>(from)]});
  exchange({}, incoming);
  return all;
}

void MpiRanks::broadcast(std::span<std::byte> bytes, int from) const {
  for (std::size_t begin = 0; begin < bytes.size(); begin += chunk_)
    MPI_Bcast(bytes.data() + begin, static_cast<int>(std::min(chunk_, bytes.size() - begin)), MPI_BYTE, from, world_);
}

void MpiRanks::broadcast(Bytes& bytes) {
  auto size = static_cast<std::int64_t>(bytes.size());
  MPI_Bcast(&size, 1, MPI_INT64_T, 0, world_);
  bytes.resize(static_cast<std::size_t>(size));
  broadcast(bytes, 0);
}

bool MpiRanks::all_arrive(double seconds) {
  using std::chrono::steady_clock;
  MPI_Request arrival;
  MPI_Ibarrier(last_, &arrival);
  const auto begin = steady_clock::now();
  while (true) {
    int have_arrived = 0;
    MPI_Test(&arrival, &have_arrived, MPI_STATUS_IGNORE);
    if (have_arrived != 0) return true;
    if (std::chrono::duration<double>(steady_clock::now() - begin).count() > seconds) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void MpiRanks::end_all(int exit_code) noexcept {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::_Exit(exit_code);
}

}  // namespace perimpact
