/// Processes that run one simulation together, and the message passing between them.
///
/// Every rank calls the collective functions in the same order. Their results are the same on all ranks and do not depend on how the ranks are scheduled,
/// since sums are of integers. The solver knows this interface only; MPI is behind it in a library of its own (src/ranks_mpi).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "perimpact/ranks/traffic.hpp"

namespace perimpact {

class Ranks {
 public:
  using Bytes = std::vector<std::byte>;
  struct Outgoing {
    int to;
    std::span<const std::byte> bytes;
  };
  struct Incoming {
    int from;
    std::span<std::byte> bytes;
  };

  virtual ~Ranks() = default;
  virtual int rank() const = 0;  ///< of this process, from 0
  virtual int size() const = 0;
  bool is_root() const { return rank() == 0; }  ///< the rank that writes the results

  /// Sends and receives messages, at most one to and one from each other rank; both sides know their lengths.
  virtual void exchange(std::span<const Outgoing> send, std::span<const Incoming> receive) = 0;
  /// Replaces each value by its sum over all ranks; integers wrap.
  virtual void sum(std::span<std::int64_t> values) = 0;
  /// Replaces each value by the largest on any rank.
  virtual void max(std::span<double> values) = 0;
  /// The bytes of all ranks, in their order, on every rank.
  virtual std::vector<Bytes> gather_all(std::span<const std::byte> bytes) = 0;
  /// The same on the root; empty elsewhere.
  virtual std::vector<Bytes> gather(std::span<const std::byte> bytes) = 0;
  /// Replaces the bytes by those of the root.
  virtual void broadcast(Bytes& bytes) = 0;
  /// Ends the run on all ranks, which fail in their current or next collective call.
  virtual void abort() noexcept = 0;
  /// What this rank has sent so far; nothing where it is not counted (counting_ranks.hpp).
  virtual Traffic traffic() const { return {}; }

  std::int64_t sum(std::int64_t value) {
    sum(std::span(&value, 1));
    return value;
  }
  double max(double value) {
    max(std::span(&value, 1));
    return value;
  }
  double min(double value) { return -max(-value); }
  bool any(bool value) { return max(value ? 1.0 : 0.0) != 0; }

  /// The values of all ranks, one after another, on every rank.
  template <class T>
  std::vector<T> join_all(std::span<const T> values) {
    return joined<T>(gather_all(std::as_bytes(values)));
  }
  /// The same on the root; empty elsewhere.
  template <class T>
  std::vector<T> join(std::span<const T> values) {
    return joined<T>(gather(std::as_bytes(values)));
  }

 private:
  template <class T>
  static std::vector<T> joined(const std::vector<Bytes>& of_ranks) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> all;
    for (const Bytes& bytes : of_ranks) {
      const std::size_t before = all.size();
      all.resize(before + bytes.size() / sizeof(T));
      if (!bytes.empty()) std::memcpy(all.data() + before, bytes.data(), bytes.size());
    }
    return all;
  }
};

/// A run of one process.
class Alone final : public Ranks {
 public:
  int rank() const override { return 0; }
  int size() const override { return 1; }
  void exchange(std::span<const Outgoing>, std::span<const Incoming>) override {}
  using Ranks::max;
  using Ranks::sum;
  void sum(std::span<std::int64_t>) override {}
  void max(std::span<double>) override {}
  std::vector<Bytes> gather_all(std::span<const std::byte> bytes) override { return {Bytes(bytes.begin(), bytes.end())}; }
  std::vector<Bytes> gather(std::span<const std::byte> bytes) override { return gather_all(bytes); }
  void broadcast(Bytes&) override {}
  void abort() noexcept override {}
};

/// The ranks of whoever is alone; without state.
inline Ranks& alone() {
  static Alone one;
  return one;
}

}  // namespace perimpact
