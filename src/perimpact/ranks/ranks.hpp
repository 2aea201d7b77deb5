/// Processes that run one simulation together, and the message passing between them.
///
/// Every rank calls the collective functions in the same order. Their results are the same on all ranks and do not depend on how the ranks are scheduled,
/// since sums are of integers. The solver knows this interface only; MPI is behind it in a library of its own (src/ranks_mpi).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
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

  /// Messages under way. Their bytes must stay in place until they are complete.
  class Exchange {
   public:
    virtual ~Exchange() = default;
    virtual void complete() = 0;  ///< returns when all have been received and sent; to be called once
  };
  /// Begins to send and receive messages, at most one to and one from each other rank; both sides know their lengths. Other calls may follow before it is
  /// complete.
  virtual std::unique_ptr<Exchange> begin_exchange(std::span<const Outgoing> send, std::span<const Incoming> receive) = 0;
  void exchange(std::span<const Outgoing> send, std::span<const Incoming> receive) { begin_exchange(send, receive)->complete(); }
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

  /// Runs of values that the root has, of each rank its own. `runs`: first and count of each, alternately. Collective.
  template <class T>
  std::vector<T> distribute(std::span<const T> on_root, std::span<const std::uint64_t> runs) {
    std::size_t count = 0;
    for (std::size_t k = 1; k < runs.size(); k += 2) count += runs[k];
    std::vector<T> own(count);
    const std::vector<Bytes> runs_of_ranks = gather(std::as_bytes(runs));
    std::vector<std::vector<T>> sent(runs_of_ranks.size());
    std::vector<Outgoing> outgoing;
    std::vector<Incoming> incoming;
    for (std::size_t to = 0; to < sent.size(); ++to) {
      std::vector<std::uint64_t> wanted(runs_of_ranks[to].size() / sizeof(std::uint64_t));
      if (!wanted.empty()) std::memcpy(wanted.data(), runs_of_ranks[to].data(), runs_of_ranks[to].size());
      for (std::size_t k = 0; k < wanted.size(); k += 2)
        sent[to].insert(sent[to].end(), on_root.begin() + static_cast<std::ptrdiff_t>(wanted[k]),
                        on_root.begin() + static_cast<std::ptrdiff_t>(wanted[k] + wanted[k + 1]));
      if (to != 0 && !sent[to].empty()) outgoing.push_back({static_cast<int>(to), std::as_bytes(std::span(sent[to]))});
    }
    if (is_root())
      own = std::move(sent.front());
    else if (count > 0)
      incoming.push_back({0, std::as_writable_bytes(std::span(own))});
    exchange(outgoing, incoming);
    return own;
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
  std::unique_ptr<Exchange> begin_exchange(std::span<const Outgoing>, std::span<const Incoming>) override {
    struct Nothing final : Exchange {
      void complete() override {}
    };
    return std::make_unique<Nothing>();
  }
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
