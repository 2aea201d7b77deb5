/// Ranks that pass messages by MPI. All calls are made by the thread that has opened it.
#pragma once

#include <mpi.h>

#include <cstddef>

#include "perimpact/ranks/processes.hpp"

namespace perimpact {

class MpiRanks final : public Processes {
 public:
  /// Starts MPI. `chunk`: [bytes] longer messages travel in several parts, since MPI counts in int; a multiple of eight.
  explicit MpiRanks(std::size_t chunk = std::size_t{1} << 30);
  ~MpiRanks() override;  ///< ends MPI
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  std::unique_ptr<Exchange> begin_exchange(std::span<const Outgoing> send, std::span<const Incoming> receive) override;
  using Ranks::max;
  using Ranks::sum;
  void sum(std::span<std::int64_t> values) override;
  void max(std::span<double> values) override;
  std::vector<Bytes> gather_all(std::span<const std::byte> bytes) override;
  std::vector<Bytes> gather(std::span<const std::byte> bytes) override;
  void broadcast(Bytes& bytes) override;
  bool all_arrive(double seconds) override;
  [[noreturn]] void end_all(int exit_code) noexcept override;

 private:
  std::vector<std::int64_t> sizes_of_all(std::size_t own) const;
  void broadcast(std::span<std::byte> bytes, int from) const;
  template <class T>
  void combine(std::span<T> values, MPI_Datatype type, MPI_Op operation) const;

  std::size_t chunk_;
  MPI_Comm world_, last_;  // last_: for all_arrive alone, while other ranks may be in a collective call
  int rank_ = 0, size_ = 0;
};

}  // namespace perimpact
