/// What a run computes from step to step, for comparison between numbers of ranks and threads.
#pragma once

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "fixtures/threads.hpp"
#include "perimpact/ranks/in_process.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace fixtures {

using namespace perimpact;

struct Trace {
  std::vector<std::uint64_t> hashes;      ///< of the state after every fifth step and the last
  std::vector<std::vector<double>> rows;  ///< of the history
  std::size_t contacts = 0;               ///< of impactors, summed over steps
  std::int64_t broken_bonds = 0;          ///< of all bodies
};

/// Runs the setup to its end, with ranks that are threads of this process and `threads` threads each.
inline Trace trace(const Setup& setup, int ranks, int threads = 1) {
  Trace of_root;
  const fixtures::Threads with_several(threads);
  run_in_process(ranks, [&](Ranks& its) {
    Trace trace;
    Simulation simulation(setup, {}, its);
    while (!simulation.clock().is_finished()) {
      simulation.step();
      trace.contacts += simulation.contacts();
      if (simulation.clock().step % 5 == 0 || simulation.clock().is_finished()) trace.hashes.push_back(simulation.state_hash());
      if (simulation.monitors().is_due(simulation.clock())) trace.rows.emplace_back(simulation.monitors().row().begin(), simulation.monitors().row().end());
    }
    for (const Body& body : simulation.bodies()) trace.broken_bonds += static_cast<std::int64_t>(body.internal.broken_bonds());
    if (its.is_root()) of_root = trace;
  });
  return of_root;
}

/// State of the whole run by name; on the root, elsewhere empty.
using WholeState = std::map<std::string, std::vector<std::byte>>;

inline WholeState state_of_all_ranks(Simulation& simulation) {
  WholeState state;
  simulation.visit_whole_state([&](std::string_view name, auto&& values) {
    const auto bytes = std::as_bytes(std::span(fccda::numbers_in(values)));
    state[std::string(name)].assign(bytes.begin(), bytes.end());
  });
  return state;
}

/// Gives a simulation, on each rank, the state of another.
inline void take(Simulation& simulation, const WholeState& state) {
  simulation.take_whole_state([&](std::string_view name, auto&& values) {
    const std::vector<std::byte>& bytes = state.at(std::string(name));
    using Values = std::remove_cvref_t<decltype(values)>;
    if constexpr (fccda::is_list<Values>) values.resize(bytes.size() / sizeof(typename Values::value_type));
    const auto numbers = fccda::numbers_in(values);
    REQUIRE(numbers.size_bytes() == bytes.size());
    if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  });
}

/// Checks that 3 ranks of two threads and 8 of one compute bitwise what one computes: lattices divided along one axis, and along two. Returns what one
/// computes. All pairs are for benchmarks/ranks/equality.py.
inline Trace expect_equal_on_ranks(const Setup& setup) {
  const Trace one = trace(setup, 1);
  for (const auto& [ranks, threads] : {std::pair(3, 2), {8, 1}}) {
    CAPTURE(ranks);
    CAPTURE(threads);
    const Trace other = trace(setup, ranks, threads);
    CHECK(other.hashes == one.hashes);
    CHECK(other.rows == one.rows);
    CHECK(other.contacts == one.contacts);
  }
  return one;
}

}  // namespace fixtures
