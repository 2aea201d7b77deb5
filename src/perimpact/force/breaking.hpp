/// When the bonds of a body break: the rule, the limits of its bonds, and what the loop over bonds asks.
#pragma once

#include <optional>
#include <vector>

#include "perimpact/damage/breaking_rule.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/force/bond_loop.hpp"

namespace perimpact {

/// The limits of a bond in tension, the same for all particles.
struct TensionOnStencil {
  std::span<const double> squared_limits;  ///< [m²] of each bond of the stencil
  template <class Pack>
  Pack squared_limit(std::size_t index) const {
    return Pack(squared_limits[index]);
  }
};
struct TensionOnList {
  const double* length;  ///< [m] |ξ| of each entry
  double longest;        ///< 1 + s_c
  template <class Pack>
  Pack squared_limit(std::size_t index) const {
    const Pack limit = Pack(longest) * fccda::load<Pack>(length + index);
    return limit * limit;
  }
};

/// Breaks bonds longer than their limit, and counts them.
template <class Limits>
struct BreakInTension {
  static constexpr bool is_armed = true;
  Limits limits;
  std::size_t* broken = nullptr;  ///< bond ends broken

  BreakInTension counting(std::size_t& ends) const { return {limits, &ends}; }
  void count(unsigned bits) const { *broken += static_cast<std::size_t>(__builtin_popcount(bits)); }
  template <class Pack>
  Pack of(std::size_t) const {
    return Pack(0.0);
  }
  template <class Pack, class Neighbour>
  unsigned bits(std::size_t index, Pack squared_length, Pack, const Neighbour&) const {
    return fccda::bits_where_greater(squared_length, limits.template squared_limit<Pack>(index));
  }
};

struct LengthOnStencil {
  std::span<const double> lengths;
  template <class Pack>
  Pack length(std::size_t index) const {
    return Pack(lengths[index]);
  }
};
struct LengthOnList {
  const double* lengths;
  template <class Pack>
  Pack length(std::size_t index) const {
    return fccda::load<Pack>(lengths + index);
  }
};

/// The whole rule, with the strength of the two particles: |η + ξ| > (1 + s_c k) |ξ|, or < (1 - s_m k) |ξ| where this is a length; k = (k_i + k_j)/2.
template <class Lengths, bool in_compression>
struct BreakByStrength {
  static constexpr bool is_armed = true;
  Lengths lengths;
  double stretch, compression;
  const double* half_strength;
  std::size_t* broken = nullptr;

  BreakByStrength counting(std::size_t& ends) const { return {lengths, stretch, compression, half_strength, &ends}; }
  void count(unsigned bits) const { *broken += static_cast<std::size_t>(__builtin_popcount(bits)); }
  template <class Pack>
  Pack of(std::size_t slot) const {
    return fccda::load<Pack>(half_strength + slot);
  }
  template <class Pack, class Neighbour>
  unsigned bits(std::size_t index, Pack squared_length, Pack of_i, const Neighbour& j) const {
    using namespace fccda;
    const Pack strength = of_i + j.of(half_strength), length = lengths.template length<Pack>(index);
    const Pack longest = fused(Pack(stretch), strength, Pack(1.0)) * length;
    unsigned broken_bits = bits_where_greater(squared_length, longest * longest);
    if constexpr (in_compression) {
      const Pack shortest = larger(fused(Pack(-compression), strength, Pack(1.0)), Pack(0.0)) * length;
      broken_bits |= bits_where_greater(shortest * shortest, squared_length);
    }
    return broken_bits;
  }
};

class Breaking {
 public:
  /// Bonds never break.
  Breaking() = default;
  /// `strength` [-] of each slot (damage/strength.hpp); where empty, 1 everywhere.
  Breaking(const BreakingRule& rule, const std::vector<double>& strength, const Family& family, const Particles& particles);

  /// Takes up how far the particles are pressed together where they are now, for rules that ask for it. Before each pass in which bonds may break.
  template <class Pack>
  void follow(const Particles& particles, Family& family);

  bool is_armed() const { return rule_.has_value(); }
  const std::optional<BreakingRule>& rule() const { return rule_; }
  double bytes() const {
    return static_cast<double>(sizeof(double) * (half_strength_.slots() + first_half_strength_.size() + squared_limits_.size() + lengths_.size()));
  }

  /// Calls f(breaker) with the kind of breaker that does no more than the rule needs. `family`: the one of the constructor; `may_break` false: no bond
  /// breaks now.
  template <class Bonds, class F>
  void choose(const Family& family, bool may_break, const F& f) const {
    constexpr bool on_stencil = std::is_same_v<Bonds, StencilBonds>;
    using Lengths = std::conditional_t<on_stencil, LengthOnStencil, LengthOnList>;
    if (!rule_ || !may_break) return f(Unbreakable{});
    if (half_strength_.slots() == 0) {
      if constexpr (on_stencil)
        return f(BreakInTension<TensionOnStencil>{{squared_limits_}});
      else
        return f(BreakInTension<TensionOnList>{{family.list()->length.data(), 1 + rule_->stretch}});
    }
    Lengths lengths;
    if constexpr (on_stencil)
      lengths = {lengths_};
    else
      lengths = {family.list()->length.data()};
    if (rule_->compression)
      f(BreakByStrength<Lengths, true>{lengths, rule_->stretch, *rule_->compression, half_strength_.component(0)});
    else
      f(BreakByStrength<Lengths, false>{lengths, rule_->stretch, 0, half_strength_.component(0)});
  }

 private:
  std::optional<BreakingRule> rule_;
  std::vector<double> squared_limits_, lengths_;  // [m²] [m] of each bond of the stencil
  ScalarArray half_strength_;                     // [-] k/2; empty where all are 1 and compression changes nothing
  std::vector<double> first_half_strength_;       // [-] where the rule hardens: the same of particles that are not pressed together
};

}  // namespace perimpact
