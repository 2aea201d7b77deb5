/// Breakers: the limits of bonds as the loop over bonds evaluates them (force/bond_loop.hpp).
#pragma once

#include <cstddef>

#include "base/host_device.hpp"
#include "base/pack.hpp"
#include "perimpact/force/bond_loop.hpp"

namespace perimpact {

/// Tensile limits of bonds, the same for all particles.
struct TensionOnStencil {
  const double* squared_limits;  ///< [m²] of each bond of the stencil
  template <class Visit>
  void visit_pointers(const Visit& visit) {
    visit(squared_limits);
  }
  template <class Pack>
  FCCDA_HD Pack squared_limit(std::size_t index) const {
    return Pack(squared_limits[index]);
  }
};
struct TensionOnList {
  const double* length;  ///< [m] |ξ| of each entry
  double longest;        ///< 1 + s_c
  template <class Pack>
  FCCDA_HD Pack squared_limit(std::size_t index) const {
    const Pack limit = Pack(longest) * fccda::load<Pack>(length + index);
    return limit * limit;
  }
};

/// Failure in tension only: breaks bonds longer than their limit.
template <class Limits>
struct BreakInTension {
  static constexpr bool is_armed = true;
  Limits limits;
  BeyondLimit beyond{};

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    limits.visit_pointers(visit);
  }
  FCCDA_HD BreakInTension with(const BeyondLimit& what) const { return {limits, what}; }
  template <class Pack>
  FCCDA_HD Pack of(std::size_t) const {
    return Pack(0.0);
  }
  template <class Pack, class Neighbour>
  FCCDA_HD unsigned bits(std::size_t index, Pack squared_length, Pack, const Neighbour&) const {
    return fccda::bits_where_greater(squared_length, limits.template squared_limit<Pack>(index));
  }
};

struct LengthOnStencil {
  const double* lengths;
  template <class Visit>
  void visit_pointers(const Visit& visit) {
    visit(lengths);
  }
  template <class Pack>
  FCCDA_HD Pack length(std::size_t index) const {
    return Pack(lengths[index]);
  }
};
struct LengthOnList {
  const double* lengths;
  template <class Pack>
  FCCDA_HD Pack length(std::size_t index) const {
    return fccda::load<Pack>(lengths + index);
  }
};

/// The full rule, with the strength of the two particles: |η + ξ| > (1 + s_c k) |ξ|, or < (1 - s_m k) |ξ| if this is positive; k = (k_i + k_j)/2.
template <class Lengths, bool in_compression>
struct BreakByStrength {
  static constexpr bool is_armed = true;
  Lengths lengths;
  double stretch, compression;
  const double* half_strength;
  BeyondLimit beyond{};

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    lengths.visit_pointers(visit);
    visit(half_strength);
  }
  FCCDA_HD BreakByStrength with(const BeyondLimit& what) const { return {lengths, stretch, compression, half_strength, what}; }
  template <class Pack>
  FCCDA_HD Pack of(std::size_t slot) const {
    return fccda::load<Pack>(half_strength + slot);
  }
  template <class Pack, class Neighbour>
  FCCDA_HD unsigned bits(std::size_t index, Pack squared_length, Pack of_i, const Neighbour& j) const {
    using namespace fccda;
    const Pack strength = of_i + j.of(half_strength), length = lengths.template length<Pack>(index);
    const Pack longest = fused_multiply_add(Pack(stretch), strength, Pack(1.0)) * length;
    unsigned broken_bits = bits_where_greater(squared_length, longest * longest);
    if constexpr (in_compression) {
      const Pack shortest = larger(fused_multiply_add(Pack(-compression), strength, Pack(1.0)), Pack(0.0)) * length;
      broken_bits |= bits_where_greater(shortest * shortest, squared_length);
    }
    return broken_bits;
  }
};

}  // namespace perimpact
