/// Loop over the bonds of a pack of particles, common to all materials and passes, for lattices (stencil) and point clouds (bond list).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/pack.hpp"
#include "base/vec3.hpp"
#include "perimpact/family/family.hpp"

namespace perimpact {

using fccda::Vec3;

/// Bonds of a lattice: the neighbours of consecutive particles are consecutive too.
class StencilBonds {
 public:
  explicit StencilBonds(Family& family) : family_(family), offsets_(family.offsets()) {}

  template <class Pack>
  struct Neighbour {
    std::ptrdiff_t slot;  // of the first lane
    Pack of(const double* values) const { return fccda::load<Pack>(values + slot); }
    std::size_t slot_of(std::size_t lane) const { return static_cast<std::size_t>(slot) + lane; }
  };
  std::uint8_t* bytes(std::size_t eight) const { return family_.bytes(eight); }
  std::size_t rows(std::size_t) const { return offsets_.size(); }
  std::size_t index(std::size_t, std::size_t row, std::size_t) const { return row; }
  template <class Pack>
  Neighbour<Pack> neighbour(std::size_t slot, std::size_t index) const {
    return {static_cast<std::ptrdiff_t>(slot) + offsets_[index]};
  }

 private:
  Family& family_;
  std::span<const std::ptrdiff_t> offsets_;
};

/// Bonds of a point cloud: each lane has its own neighbour.
class ListedBonds {
 public:
  explicit ListedBonds(Family& family) : family_(family), list_(*family.list()) {}

  template <class Pack>
  struct Neighbour {
    const std::int32_t* slots;
    Pack of(const double* values) const { return fccda::gather<Pack>(values, slots); }
    std::size_t slot_of(std::size_t lane) const { return static_cast<std::size_t>(slots[lane]); }
  };
  std::uint8_t* bytes(std::size_t eight) const { return family_.bytes(eight); }
  std::size_t rows(std::size_t eight) const { return list_.begin[eight + 1] - list_.begin[eight]; }
  std::size_t index(std::size_t eight, std::size_t row, std::size_t first) const { return (list_.begin[eight] + row) * fccda::byte_lanes + first; }
  template <class Pack>
  Neighbour<Pack> neighbour(std::size_t, std::size_t index) const {
    return {list_.neighbour.data() + index};
  }

 private:
  Family& family_;
  const BondList& list_;
};

/// One bond of each particle of a pack in the current configuration.
template <class Pack, class Bonds>
struct DeformedBond {
  std::size_t index;                                   ///< of the bond in the stencil, or of the first lane's entry in the list
  typename Bonds::template Neighbour<Pack> neighbour;  ///< neighbour.of(array): the neighbours' values
  unsigned intact;                                     ///< bit l: the bond of lane l exists
  Vec3<Pack> between;                                  ///< y_j - y_i [m]
  Pack squared_length;                                 ///< [m²]
};

/// Treatment of bonds beyond their limits.
struct BeyondLimit {
  std::uint32_t* broken = nullptr;  ///< they break; counter of broken ends
  bool* is_noted = nullptr;         ///< if given, they stay intact, this is set to true, and the remaining bonds are skipped
};

/// Breaker that breaks no bond.
struct Unbreakable {
  static constexpr bool is_armed = false;
  Unbreakable with(const BeyondLimit&) const { return {}; }
  template <class Pack>
  Pack of(std::size_t) const {
    return Pack(0.0);
  }
};

/// Default per_broken: ignores broken bonds.
struct LeaveBroken {
  template <class Bond>
  void operator()(const Bond&) const {}
};

/// Calls per_bond(DeformedBond) for every bond that is intact for at least one particle of the pack. `x`: components of the current positions;
/// `breaking`: damage/breaking.hpp. Calls per_broken(DeformedBond) for bonds that break, with the lanes in which they break as `intact`.
///
/// Bonds break in this loop, where the squared length is available: this adds 10 to 20 % to its cost, a separate pass 45 %. The squared length is
/// bitwise identical at both ends of a bond, so that they break together.
template <class Pack, class Bonds, class Breaking, class PerBond, class PerBroken = LeaveBroken>
inline void for_each_bond(const Bonds& bonds, const std::array<const double*, 3>& x, std::size_t slot, const Breaking& breaking, PerBond&& per_bond,
                          [[maybe_unused]] const PerBroken& per_broken = {}) {
  using namespace fccda;
  const Vec3<Pack> xi{load<Pack>(x[0] + slot), load<Pack>(x[1] + slot), load<Pack>(x[2] + slot)};
  const std::size_t eight = slot / byte_lanes, first = slot % byte_lanes, rows = bonds.rows(eight);
  std::uint8_t* bytes = bonds.bytes(eight);
  [[maybe_unused]] const Pack strength = breaking.template of<Pack>(slot);
  for (std::size_t row = 0; row < rows; ++row) {
    unsigned intact = pack_bits<Pack>(bytes[row], first);
    if (intact == 0) continue;
    const std::size_t index = bonds.index(eight, row, first);
    const auto neighbour = bonds.template neighbour<Pack>(slot, index);
    const Vec3<Pack> between{neighbour.of(x[0]) - xi.x, neighbour.of(x[1]) - xi.y, neighbour.of(x[2]) - xi.z};
    const Pack squared_length = fused_multiply_add(between.z, between.z, fused_multiply_add(between.y, between.y, between.x * between.x));
    if constexpr (Breaking::is_armed) {
      const unsigned broken = intact & breaking.bits(index, squared_length, strength, neighbour);
      if (broken) [[unlikely]] {
        if (breaking.beyond.is_noted) {
          *breaking.beyond.is_noted = true;
          return;
        }
        *breaking.beyond.broken += static_cast<std::uint32_t>(__builtin_popcount(broken));
        bytes[row] = static_cast<std::uint8_t>(bytes[row] & ~(broken << first));
        intact &= ~broken;
        per_broken(DeformedBond<Pack, Bonds>{index, neighbour, broken, between, squared_length});
      }
    }
    per_bond(DeformedBond<Pack, Bonds>{index, neighbour, intact, between, squared_length});
  }
}

}  // namespace perimpact
