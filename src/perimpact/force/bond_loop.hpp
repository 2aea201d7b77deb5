/// Loop over the bonds of a pack of particles, common to all materials and passes, for lattices (stencil) and point clouds (bond list).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "base/pack.hpp"
#include "base/vec3.hpp"
#include "perimpact/family/family.hpp"

namespace perimpact {

using fccda::Vec3;

/// Bits of the bonds of eight neighbouring slots, a byte for each row, as seen by a pack of them.
class BitsOfPack {
 public:
  FCCDA_HD BitsOfPack(std::uint8_t* bytes, std::size_t first) : bytes_(bytes), first_(first) {}
  template <class Pack>
  FCCDA_HD unsigned intact(std::size_t row) const {
    return fccda::pack_bits<Pack>(bytes_[row], first_);
  }
  FCCDA_HD void clear(std::size_t row, unsigned broken) { bytes_[row] = static_cast<std::uint8_t>(bytes_[row] & ~(broken << first_)); }

 private:
  std::uint8_t* bytes_;
  std::size_t first_;  // lane of the byte that is the first lane of the pack
};

/// Neighbours along the bonds of a lattice: those of consecutive particles are consecutive too.
template <class Pack>
struct StencilNeighbour {
  std::ptrdiff_t slot;  // of the first lane
  FCCDA_HD Pack of(const double* values) const { return fccda::load<Pack>(values + slot); }
  FCCDA_HD std::size_t slot_of(std::size_t lane) const { return static_cast<std::size_t>(slot) + lane; }
};

/// Geometry of the bonds of a lattice, without their bits. `Count`: of rows.
template <class Count>
class BondsAlongStencil {
 public:
  template <class Pack>
  using Neighbour = StencilNeighbour<Pack>;
  FCCDA_HD std::size_t rows(std::size_t) const { return rows_; }
  FCCDA_HD std::size_t index(std::size_t, std::size_t row, std::size_t) const { return row; }
  template <class Pack>
  FCCDA_HD Neighbour<Pack> neighbour(std::size_t slot, std::size_t index) const {
    return {static_cast<std::ptrdiff_t>(slot) + offsets_[index]};
  }

 protected:
  /// `offsets`: in slots, of each bond of the stencil.
  BondsAlongStencil(const std::ptrdiff_t* offsets, std::size_t rows) : offsets_(offsets), rows_(static_cast<Count>(rows)) {}

 private:
  const std::ptrdiff_t* offsets_;
  Count rows_;
};

/// Bonds of a lattice.
class StencilBonds : public BondsAlongStencil<std::size_t> {
 public:
  explicit StencilBonds(Family& family) : BondsAlongStencil(family.offsets().data(), family.offsets().size()), bits_(family.bytes(0)) {}

  /// The same bonds with other bits.
  StencilBonds with(std::uint8_t* bits) const {
    StencilBonds others = *this;
    others.bits_ = bits;
    return others;
  }
  FCCDA_HD std::uint8_t* bytes(std::size_t eight) const { return bits_ + eight * rows(eight); }
  FCCDA_HD BitsOfPack bits(std::size_t slot) const { return {bytes(slot / fccda::byte_lanes), slot % fccda::byte_lanes}; }

 private:
  std::uint8_t* bits_;
};

/// Bonds of a point cloud: each lane has its own neighbour.
class ListedBonds {
 public:
  explicit ListedBonds(Family& family) : bits_(family.bytes(0)), begin_(family.list()->begin.data()), neighbour_(family.list()->neighbour.data()) {}

  template <class Pack>
  struct Neighbour {
    const std::int32_t* slots;
    FCCDA_HD Pack of(const double* values) const { return fccda::gather<Pack>(values, slots); }
    FCCDA_HD std::size_t slot_of(std::size_t lane) const { return static_cast<std::size_t>(slots[lane]); }
  };
  /// The same bonds with other bits.
  ListedBonds with(std::uint8_t* bits) const {
    ListedBonds others = *this;
    others.bits_ = bits;
    return others;
  }
  FCCDA_HD std::uint8_t* bytes(std::size_t eight) const { return bits_ + begin_[eight]; }
  FCCDA_HD BitsOfPack bits(std::size_t slot) const { return {bytes(slot / fccda::byte_lanes), slot % fccda::byte_lanes}; }
  FCCDA_HD std::size_t rows(std::size_t eight) const { return begin_[eight + 1] - begin_[eight]; }
  FCCDA_HD std::size_t index(std::size_t eight, std::size_t row, std::size_t first) const { return (begin_[eight] + row) * fccda::byte_lanes + first; }
  template <class Pack>
  FCCDA_HD Neighbour<Pack> neighbour(std::size_t, std::size_t index) const {
    return {neighbour_ + index};
  }

 private:
  std::uint8_t* bits_;
  const std::size_t* begin_;       // first row of each eight, and one past the last
  const std::int32_t* neighbour_;  // of each entry
};

/// One bond of each particle of a pack in the current configuration.
template <class Pack, class Bonds>
struct DeformedBond {
  std::size_t index;                                   ///< of the bond in the stencil, or of the first lane's entry in the list
  typename Bonds::template Neighbour<Pack> neighbour;  ///< neighbour.of(array): the neighbours' values
  unsigned intact;                                     ///< bit l: the bond of lane l exists
  Vec3<Pack> between;                                  ///< y_j - y_i [m]
  Pack squared_length;                                 ///< [m²]

  /// `value` in the lanes whose bond exists, 0 in the others.
  FCCDA_HD Pack where_intact(Pack value) const {
    if constexpr (fccda::lanes<Pack> == 4)  // with AVX2 a mask is four instructions, and most bonds need none
      if (intact == 15) [[likely]]
        return value;
    return fccda::select(intact, value);
  }
};

/// Treatment of bonds beyond their limits.
struct BeyondLimit {
  std::uint32_t* broken = nullptr;  ///< they break; counter of broken ends
  bool* is_noted = nullptr;         ///< if given, they stay intact, this is set to true, and the remaining bonds are skipped
};

/// Breaker that breaks no bond.
struct Unbreakable {
  static constexpr bool is_armed = false;
  template <class Visit>
  void visit_pointers(const Visit&) {}
  FCCDA_HD Unbreakable with(const BeyondLimit&) const { return {}; }
  template <class Pack>
  FCCDA_HD Pack of(std::size_t) const {
    return Pack(0.0);
  }
};

/// Default per_broken: ignores broken bonds.
struct LeaveBroken {
  template <class Bond>
  FCCDA_HD void operator()(const Bond&) const {}
};

/// A copy for packs, which stays in registers: bytes of broken bonds are written in the loop, and a byte may alias anything. On a device the parameters of
/// a kernel are constants, and registers are scarce.
template <class Pack, class T>
using InRegisters = std::conditional_t<(fccda::lanes<Pack> > 1), const T, const T&>;

/// Calls per_bond(DeformedBond) for every bond that is intact for at least one particle of the pack. `positions`: components of the current
/// ones; `breaking`: damage/breaking.hpp. Calls per_broken(DeformedBond) for bonds that break, with the lanes in which they break as `intact`.
///
/// Bonds break in this loop, where the squared length is available: this adds 10 to 20 % to its cost, a separate pass 45 %. The squared length is
/// bitwise identical at both ends of a bond, so that they break together.
template <class Pack, class Bonds, class Breaking, class PerBond, class PerBroken = LeaveBroken>
FCCDA_HD inline void for_each_bond(const Bonds& all_bonds, const std::array<const double*, 3>& positions, std::size_t slot, const Breaking& breaking,
                                   PerBond&& per_bond, [[maybe_unused]] const PerBroken& per_broken = {}) {
  using namespace fccda;
  InRegisters<Pack, Bonds> bonds = all_bonds;
  InRegisters<Pack, std::array<const double*, 3>> x = positions;
  const Pack minus(-1.0);  // x_j + (-x_i) needs one instruction less than x_j - x_i, and has its bits
  const Vec3<Pack> minus_xi{minus * load<Pack>(x[0] + slot), minus * load<Pack>(x[1] + slot), minus * load<Pack>(x[2] + slot)};
  const std::size_t eight = slot / byte_lanes, first = slot % byte_lanes, rows = bonds.rows(eight);
  auto bits = bonds.bits(slot);
  [[maybe_unused]] const Pack strength = breaking.template of<Pack>(slot);
  for (std::size_t row = 0; row < rows; ++row) {
    unsigned intact = bits.template intact<Pack>(row);
    if (intact == 0) continue;
    const std::size_t index = bonds.index(eight, row, first);
    const auto neighbour = bonds.template neighbour<Pack>(slot, index);
    const Vec3<Pack> between{neighbour.of(x[0]) + minus_xi.x, neighbour.of(x[1]) + minus_xi.y, neighbour.of(x[2]) + minus_xi.z};
    const Pack squared_length = fused_multiply_add(between.z, between.z, fused_multiply_add(between.y, between.y, between.x * between.x));
    if constexpr (Breaking::is_armed) {
      const unsigned broken = intact & breaking.bits(index, squared_length, strength, neighbour);
      if (broken) [[unlikely]] {
        if (breaking.beyond.is_noted) {
          *breaking.beyond.is_noted = true;
          return;
        }
        *breaking.beyond.broken += static_cast<std::uint32_t>(std::popcount(broken));
        bits.clear(row, broken);
        intact &= ~broken;
        per_broken(DeformedBond<Pack, Bonds>{index, neighbour, broken, between, squared_length});
      }
    }
    per_bond(DeformedBond<Pack, Bonds>{index, neighbour, intact, between, squared_length});
  }
}

}  // namespace perimpact
