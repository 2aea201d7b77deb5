/// The loop over the bonds of a pack of particles on a lattice. Every pass over bonds is this loop with another body.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fccda/core/pack.hpp"
#include "fccda/core/vec3.hpp"

namespace perimpact {

using fccda::Vec3;

/// One bond of each particle of a pack, as it is now.
template <class Pack>
struct BondNow {
  std::size_t index;       ///< of the bond in the stencil
  std::ptrdiff_t j;        ///< slot of the first lane's neighbour
  unsigned intact;         ///< bit l: the bond of lane l exists
  Vec3<Pack> between;      ///< y_j - y_i [m]
  Pack squared_length;     ///< [m²]
};

/// Says of no bond that it breaks.
struct Unbreakable {
  static constexpr bool is_armed = false;
};

/// Breaks bonds longer than a limit given per stencil bond, and counts them.
struct BreakBeyond {
  static constexpr bool is_armed = true;
  std::span<const double> squared_limits;  ///< [m²]
  std::size_t& broken;                     ///< bond ends broken
};

/// Calls per_bond(BondNow<Pack>) for every bond of the stencil that at least one particle of the pack still has.
///
/// `x`: components of the current positions; `bytes`: bond bits of the eight slots that hold the pack, `first` its first lane among them.
/// Breaking is done here, where the squared length is at hand: a pass of its own costs 45 % more, this one 10 to 20 %. Both ends of a bond
/// compute the same squared length to the last bit, so that they break together.
template <class Pack, class Breaking, class PerBond>
inline void for_each_bond(const std::array<const double*, 3>& x, std::span<const std::ptrdiff_t> offsets, std::uint8_t* bytes, std::size_t slot, std::size_t first,
                          const Breaking& breaking, PerBond&& per_bond) {
  using namespace fccda;
  const Vec3<Pack> xi{load<Pack>(x[0] + slot), load<Pack>(x[1] + slot), load<Pack>(x[2] + slot)};
  const std::size_t count = offsets.size();
  for (std::size_t b = 0; b < count; ++b) {
    unsigned intact = pack_bits<Pack>(bytes[b], first);
    if (intact == 0) continue;
    const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(slot) + offsets[b];
    const Vec3<Pack> between{load<Pack>(x[0] + j) - xi.x, load<Pack>(x[1] + j) - xi.y, load<Pack>(x[2] + j) - xi.z};
    const Pack squared_length = fused(between.z, between.z, fused(between.y, between.y, between.x * between.x));
    if constexpr (Breaking::is_armed) {
      const unsigned broken = intact & bits_where_greater(squared_length, Pack(breaking.squared_limits[b]));
      if (broken) [[unlikely]] {
        bytes[b] = static_cast<std::uint8_t>(bytes[b] & ~(broken << first));
        breaking.broken += static_cast<std::size_t>(__builtin_popcount(broken));
        intact &= ~broken;
      }
    }
    per_bond(BondNow<Pack>{b, j, intact, between, squared_length});
  }
}

}  // namespace perimpact
