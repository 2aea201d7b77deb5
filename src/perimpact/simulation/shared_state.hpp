/// Visitors between the state of the ranks of a run and that of the run as a whole, which is that of one rank: for checkpoints and hashes, which therefore
/// do not depend on the number of ranks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/state.hpp"
#include "perimpact/body/body.hpp"
#include "perimpact/particles/shared_numbers.hpp"
#include "perimpact/simulation/state_hash.hpp"

namespace perimpact {

/// Passes the arrays of the whole run to the sink on the root, on which other arrays are the same as everywhere. Collective.
template <class Sink>
class GatheredState {
 public:
  GatheredState(std::span<const Body> bodies, Ranks& ranks, Sink sink) : bodies_(bodies), ranks_(ranks), sink_(std::move(sink)) {}

  template <class Values>
  void operator()(std::string_view name, Values&& values) {
    if (ranks_.size() == 1) return sink_(name, values);
    const auto numbers = fccda::numbers_in(values);
    using T = typename decltype(numbers)::value_type;
    if constexpr (requires { values.per_eight; }) {
      pass(name, values.share->gather(std::span<const T>(numbers), values.per_eight));
    } else if constexpr (requires { values.slots; }) {
      pass(name, values.share->gather_listed(std::span<const T>(numbers), values.slots));
    } else if constexpr (requires { values.body; }) {
      std::vector<T> points;
      for (const T point : numbers) points.push_back(bodies_[values.body].particles.share().whole_slot(point));
      points = ranks_.join_all(std::span<const T>(points));
      std::ranges::sort(points);
      pass(name, std::move(points));
    } else if constexpr (requires { values.per_pair; }) {
      const std::vector<T> joined = ranks_.join(std::span<const T>(numbers));
      if constexpr (std::is_same_v<std::remove_cvref_t<Values>, EndsOfPairs>) order(joined);
      pass(name, in_order_of_pairs(joined, values.per_pair));
    } else if constexpr (requires { values.is_own; }) {
      std::vector<T> sums;
      for (const T number : numbers) sums.push_back(static_cast<T>(ranks_.sum(static_cast<std::int64_t>(number))));
      pass(name, std::move(sums));
    } else if (ranks_.is_root()) {
      sink_(name, values);
    }
  }

 private:
  template <class T>
  void pass(std::string_view name, std::vector<T> whole) {
    if (ranks_.is_root()) sink_(name, std::span<T>(whole));
  }

  void order(std::span<const std::uint64_t> ends) {
    order_of_pairs_.resize(ends.size() / EndsOfPairs::per_pair);
    std::iota(order_of_pairs_.begin(), order_of_pairs_.end(), std::size_t{0});
    std::ranges::sort(order_of_pairs_, {}, [&](std::size_t pair) { return std::pair(ends[2 * pair], ends[2 * pair + 1]); });
  }
  template <class T>
  std::vector<T> in_order_of_pairs(const std::vector<T>& joined, std::size_t per_pair) const {
    std::vector<T> sorted;
    if (joined.empty()) return sorted;  // slips without friction
    sorted.reserve(joined.size());
    for (const std::size_t pair : order_of_pairs_)
      sorted.insert(sorted.end(), joined.begin() + static_cast<std::ptrdiff_t>(pair * per_pair),
                    joined.begin() + static_cast<std::ptrdiff_t>((pair + 1) * per_pair));
    return sorted;
  }

  std::span<const Body> bodies_;
  Ranks& ranks_;
  Sink sink_;
  std::vector<std::size_t> order_of_pairs_;
};

/// Adds this rank's terms of the hash of the whole run. Collective.
class HashOfRanks {
 public:
  HashOfRanks(std::span<const Body> bodies, Ranks& ranks, StateHash& hash) : hash_(hash), rest_(bodies, ranks, Root{hash}) {}

  template <class Values>
  void operator()(std::string_view name, Values&& values) {
    if constexpr (requires { values.per_eight; }) {
      if (values.share->is_whole()) return hash_(name, values);
      values.share->for_each_owned_run(values.per_eight, [&](std::size_t first, std::size_t first_of_whole, std::size_t count) {
        hash_.add(name, first_of_whole, std::span(values).subspan(first, count));
      });
    } else {
      rest_(name, values);
    }
  }

 private:
  struct Root {
    StateHash& hash;
    template <class Values>
    void operator()(std::string_view name, Values&& values) {
      hash(name, values);
    }
  };
  StateHash& hash_;
  GatheredState<Root> rest_;
};

/// Restores the state of this rank from a source of arrays of the whole run. Of particles only the root reads them, and passes each rank its part. Collective.
template <class Source>
class TakenState {
 public:
  TakenState(std::span<const Body> bodies, Ranks& ranks, Source source) : bodies_(bodies), ranks_(ranks), source_(std::move(source)) {}

  template <class Values>
  void operator()(std::string_view name, Values&& values) {
    if (ranks_.size() == 1) return source_(name, values);
    const auto numbers = fccda::numbers_in(values);
    using T = typename decltype(numbers)::value_type;
    if constexpr (requires { values.per_eight; }) {
      const std::size_t count = values.share->count_of_whole(values.per_eight);
      values.share->take(std::span<const T>(on_root<T>(name, count)), numbers, values.per_eight);
    } else if constexpr (requires { values.slots; }) {
      const std::size_t count = static_cast<std::size_t>(ranks_.sum(static_cast<std::int64_t>(numbers.size())));
      values.share->take_listed(std::span<const T>(on_root<T>(name, count)), numbers, values.slots);
    } else if constexpr (fccda::is_list<std::remove_cvref_t<Values>>) {
      source_(name, values);
      if constexpr (requires { values.body; }) {
        std::vector<T> own;
        for (const T point : values)
          if (const auto slot = bodies_[values.body].particles.share().owned_slot(point)) own.push_back(*slot);
        values.assign(own);
      }
    } else {
      source_(name, values);
      if constexpr (requires { values.is_own; })
        if (!ranks_.is_root()) std::ranges::fill(numbers, T{});
    }
  }

 private:
  template <class T>
  std::vector<T> on_root(std::string_view name, std::size_t count) {
    if (!ranks_.is_root()) return {};
    std::vector<T> whole(count);
    source_(name, std::span<T>(whole));
    return whole;
  }

  std::span<const Body> bodies_;
  Ranks& ranks_;
  Source source_;
};

}  // namespace perimpact
