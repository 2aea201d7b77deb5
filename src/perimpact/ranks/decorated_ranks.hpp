/// Ranks that pass every call on to others, for classes that count, time or delay calls.
#pragma once

#include <utility>

#include "perimpact/ranks/ranks.hpp"

namespace perimpact {

/// A derived class defines `around(Traffic sent, call)`, which is to call `call()`. `sent`: what this rank sends in the call.
template <class Derived>
class DecoratedRanks : public Ranks {
 public:
  explicit DecoratedRanks(Ranks& inner) : inner_(&inner) {}

  int rank() const override { return inner_->rank(); }
  int size() const override { return inner_->size(); }
  using Ranks::max;
  using Ranks::sum;
  void exchange(std::span<const Outgoing> send, std::span<const Incoming> receive) override {
    Traffic sent{.messages = static_cast<std::int64_t>(send.size())};
    for (const Outgoing& message : send) sent.bytes += size_of(message.bytes);
    derived().around(sent, [&] { inner_->exchange(send, receive); });
  }
  void sum(std::span<std::int64_t> values) override {
    derived().around(reduction_of(static_cast<std::int64_t>(values.size())), [&] { inner_->sum(values); });
  }
  void max(std::span<double> values) override {
    derived().around(reduction_of(static_cast<std::int64_t>(values.size())), [&] { inner_->max(values); });
  }
  std::vector<Bytes> gather_all(std::span<const std::byte> bytes) override {
    std::vector<Bytes> all;
    derived().around(collection_of(bytes), [&] { all = inner_->gather_all(bytes); });
    return all;
  }
  std::vector<Bytes> gather(std::span<const std::byte> bytes) override {
    std::vector<Bytes> all;
    derived().around(collection_of(bytes), [&] { all = inner_->gather(bytes); });
    return all;
  }
  void broadcast(Bytes& bytes) override {
    derived().around(collection_of(is_root() ? std::span<const std::byte>(bytes) : std::span<const std::byte>()), [&] { inner_->broadcast(bytes); });
  }
  void abort() noexcept override { inner_->abort(); }
  Traffic traffic() const override { return inner_->traffic(); }

 private:
  static std::int64_t size_of(std::span<const std::byte> bytes) { return static_cast<std::int64_t>(bytes.size()); }
  static Traffic collection_of(std::span<const std::byte> bytes) { return {.collections = 1, .collected_bytes = size_of(bytes)}; }
  Derived& derived() { return static_cast<Derived&>(*this); }

  Ranks* inner_;
};

}  // namespace perimpact
