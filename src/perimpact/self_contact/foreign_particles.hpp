/// Particles of other ranks that may come into contact with those of this rank.
///
/// They are found with each new list of pairs: each rank sends the particles that lie in the bounding boxes of others. Those that occur in pairs are then
/// refreshed from their owners in each step. A run of one rank has none.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "base/vec3.hpp"
#include "perimpact/particles/slot_array.hpp"
#include "perimpact/ranks/exchange_lists.hpp"

namespace perimpact {

class ForeignParticles {
 public:
  /// A particle as its owner describes it when a list is made.
  struct Particle {
    std::uint64_t id;  ///< ascending in the order of body and slot, the same on all ranks
    std::uint32_t body;
    std::uint8_t is_exposed, has_lost;  ///< family/exposure.hpp
    Vec3d reference, position;          ///< [m] X, x
    double size, volume;                ///< [m], [m³]
  };

  /// Finds the particles of other ranks within `reach` [m] of a box of particles of this rank. `positions` [m]: of its own particles; describe(own) of each.
  /// Collective.
  void find(Ranks& ranks, const VectorArray& positions, double reach, const std::function<Particle(std::size_t own)>& describe);

  /// Those found, by id.
  std::span<const Particle> all() const { return all_; }

  /// Leaves out of refresh() those that are not `used`, one flag each. Collective.
  void keep(Ranks& ranks, std::span<const std::uint8_t> used);

  /// Calls set(foreign, value) with the value_of(own) of its owner, each a trivially copyable T. Collective.
  template <class T, class ValueOf, class Set>
  void refresh(Ranks& ranks, const ValueOf& value_of, const Set& set) const;

 private:
  using Indices = std::map<int, std::vector<std::uint32_t>>;  // by rank
  std::vector<Particle> all_;
  Indices sent_;      // own particles
  Indices received_;  // foreign particles, in the order in which their owner sends them
};

template <class T, class ValueOf, class Set>
void ForeignParticles::refresh(Ranks& ranks, const ValueOf& value_of, const Set& set) const {
  std::map<int, std::vector<T>> sent, received;
  std::vector<Ranks::Outgoing> outgoing;
  std::vector<Ranks::Incoming> incoming;
  for (const auto& [to, own] : sent_) {
    std::vector<T>& values = sent[to];
    values.reserve(own.size());
    for (const std::uint32_t particle : own) values.push_back(value_of(particle));
    outgoing.push_back({to, std::as_bytes(std::span(values))});
  }
  for (const auto& [from, foreign] : received_) {
    std::vector<T>& values = received[from];
    values.resize(foreign.size());
    incoming.push_back({from, std::as_writable_bytes(std::span(values))});
  }
  ranks.exchange(outgoing, incoming);
  for (const auto& [from, foreign] : received_)
    for (std::size_t k = 0; k < foreign.size(); ++k) set(foreign[k], received[from][k]);
}

}  // namespace perimpact
