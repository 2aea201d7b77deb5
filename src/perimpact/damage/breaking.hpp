/// Bond failure of a body: the rule, the limits of its bonds, and their evaluation in the loop over bonds.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/parallel.hpp"
#include "perimpact/damage/breakers.hpp"
#include "perimpact/damage/breaking_rule.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/force/bond_loop.hpp"
#include "perimpact/force/pass.hpp"
#include "perimpact/force/step_messages.hpp"

namespace perimpact {

/// Bond failure of one body.
class Breaking {
 public:
  /// Bonds never break.
  Breaking() = default;
  /// `strength` [-] of each slot (damage/strength.hpp); where empty, 1 everywhere.
  Breaking(const BreakingRule& rule, const std::vector<double>& strength, const Family& family, const Particles& particles);

  /// Pass over the bonds in which they break, if options.may_break. per_pack(eight, slot, breaker) visits the bonds of a pack of particles with the breaker,
  /// writes the results of the pack, and returns its energy [J]. Counts broken ends, and sums the energy of each eight if options.with_energy.
  ///
  /// With hardening, the critical stretch depends on compression, but this matters only for bonds beyond their unconfined limit. Packs with such a bond
  /// are postponed: their strength is evaluated after all other packs. Packs postponed in the previous pass are postponed at once, so that little is
  /// evaluated twice; not so where energies are summed, since the order of summation would then depend on the previous pass.
  template <class Pack, class Bonds, class PerPack>
  void for_each_pack(const Bonds& bonds, const Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums, const PerPack& per_pack);

  /// Calls f(breaker) with the cheapest breaker for the rule, for unconfined particles.
  template <class Bonds, class F>
  void choose(const Family& family, bool may_break, const F& f) const {
    if (!rule_ || !may_break) return f(Unbreakable{});
    if (half_strength_.slots() != 0) return choose_by_strength<Bonds>(family, half_strength_, f);
    if constexpr (std::is_same_v<Bonds, StencilBonds>)
      f(BreakInTension<TensionOnStencil>{{squared_limits_.data()}});
    else
      f(BreakInTension<TensionOnList>{{family.list()->length.data(), 1 + rule_->stretch}});
  }
  /// The same with this strength, k/2 of each slot.
  template <class Bonds, class F>
  void choose_by_strength(const Family& family, const ScalarArray& half_strength, const F& f) const {
    if (rule_->compression)
      f(BreakByStrength<Lengths<Bonds>, true>{lengths<Bonds>(family), rule_->stretch, *rule_->compression, half_strength.component(0)});
    else
      f(BreakByStrength<Lengths<Bonds>, false>{lengths<Bonds>(family), rule_->stretch, 0, half_strength.component(0)});
  }

  bool is_armed() const { return rule_.has_value(); }
  /// Of a pass in which bonds may break.
  StepMessages messages() const { return {.refreshed = {}, .collectives = rule_ && rule_->hardening > 0 ? reduction_of(1) : Traffic{}}; }
  const std::optional<BreakingRule>& rule() const { return rule_; }
  /// Calls visit(span) for each array that the breakers of a lattice read or write.
  template <class Visit>
  void visit_arrays(const Visit& visit) const {
    visit(std::span(squared_limits_)), visit(std::span(lengths_));
    visit(half_strength_.with_slack()), visit(pressed_half_strength_.with_slack());
  }
  /// k/2 [-] of each slot; of unconfined particles: empty if all are 1 and there is no compressive limit. Under compression: empty without hardening.
  const ScalarArray& half_strength() const { return half_strength_; }
  const ScalarArray& pressed_half_strength() const { return pressed_half_strength_; }
  double bytes() const {
    return static_cast<double>(sizeof(double) * (half_strength_.slots() + pressed_half_strength_.slots() + squared_limits_.size() + lengths_.size()) +
                               postponed_.size() + row_has_postponed_.size() + is_asked_.size());
  }

 private:
  template <class Bonds>
  using Lengths = std::conditional_t<std::is_same_v<Bonds, StencilBonds>, LengthOnStencil, LengthOnList>;
  template <class Bonds>
  Lengths<Bonds> lengths(const Family& family) const {
    if constexpr (std::is_same_v<Bonds, StencilBonds>)
      return {lengths_.data()};
    else
      return {family.list()->length.data()};
  }

  /// Calls f(slot) for the postponed packs.
  template <class Pack, class F>
  void for_each_postponed(const Particles& particles, const F& f) const {
    for_each_pack_in_rows<Pack>(particles, [&](std::size_t row, std::size_t slot) {
      if (row_has_postponed_[row] && postponed_[slot / fccda::lanes<Pack>]) f(slot);
    });
  }

  /// Requests the strength of ghosts from their owners.
  void pass_requests(const Share& share);

  /// Computes the strength of the requested particles at their current positions.
  template <class Pack>
  void find_pressed_strength(const Particles& particles, Family& family);

  static constexpr std::uint8_t no = 0, yes = 1, needlessly = 2;

  std::optional<BreakingRule> rule_;
  std::vector<double> squared_limits_, lengths_;  // [m²] [m] of each bond of the stencil
  ScalarArray half_strength_;                     // [-] k/2 of unconfined particles; empty if all are 1 and there is no compressive limit
  // with hardening:
  ScalarArray pressed_half_strength_;    // [-] k/2 under the compression of the last request
  std::vector<std::uint8_t> is_asked_;   // of each eight slots: their strength is requested
  std::vector<std::uint8_t> postponed_;  // of each pack
  std::vector<std::uint8_t> row_has_postponed_;
};

template <class Pack, class Bonds, class PerPack>
void Breaking::for_each_pack(const Bonds& bonds, const Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums,
                             const PerPack& per_pack) {
  const bool hardens = options.may_break && rule_ && rule_->hardening > 0;
  if (hardens && options.with_energy) std::fill(postponed_.begin(), postponed_.end(), no);
  choose<Bonds>(family, options.may_break, [&](const auto& breaker) {
    for_each_pack_in_rows<Pack>(particles, [&](std::size_t row, std::size_t slot) {
      const std::size_t eight = slot / fccda::byte_lanes;
      if (options.with_energy && slot % fccda::byte_lanes == 0) sums.energy[eight] = 0;
      bool is_postponed = hardens && postponed_[slot / fccda::lanes<Pack>] != no;
      if (!is_postponed) {
        const double of_pack = per_pack(eight, slot, breaker.with({&sums.broken_ends[eight], hardens ? &is_postponed : nullptr}));
        if (!is_postponed && options.with_energy) sums.energy[eight] += of_pack;
      }
      if (is_postponed) postponed_[slot / fccda::lanes<Pack>] = row_has_postponed_[row] = yes;
    });
  });
  if (!hardens) return;
  const bool has_postponed = std::find(row_has_postponed_.begin(), row_has_postponed_.end(), yes) != row_has_postponed_.end();
  if (!particles.share().ranks().any(has_postponed)) return;

  choose<Bonds>(family, true, [&](const auto& breaker) {
    using Breaker = std::decay_t<decltype(breaker)>;
    if constexpr (Breaker::is_armed)
      for_each_postponed<Pack>(particles, [&](std::size_t slot) {
        const Pack of_i = breaker.template of<Pack>(slot);
        unsigned beyond = 0;
        for_each_bond<Pack>(bonds, particles.position.pointers(), slot, Unbreakable{}, [&](const auto& bond) {
          const unsigned bits = bond.intact & breaker.bits(bond.index, bond.squared_length, of_i, bond.neighbour);
          fccda::for_each_bit(bits, [&](std::size_t lane) {  // of the neighbours alone: they request that of this particle
            std::atomic_ref(is_asked_[bond.neighbour.slot_of(lane) / fccda::byte_lanes]).store(yes, std::memory_order_relaxed);
          });
          beyond |= bits;
        });
        if (beyond == 0) postponed_[slot / fccda::lanes<Pack>] = needlessly;
      });
  });
  if (!particles.share().is_whole()) pass_requests(particles.share());
  find_pressed_strength<Pack>(particles, family);
  particles.share().refresh({pressed_half_strength_.component(0)});
  choose_by_strength<Bonds>(family, pressed_half_strength_, [&](const auto& breaker) {
    for_each_postponed<Pack>(particles, [&](std::size_t slot) {
      const std::size_t eight = slot / fccda::byte_lanes;
      const double of_pack = per_pack(eight, slot, breaker.with({&sums.broken_ends[eight]}));
      if (options.with_energy) sums.energy[eight] += of_pack;
      std::uint8_t& postponed = postponed_[slot / fccda::lanes<Pack>];
      if (postponed == needlessly) postponed = no;
    });
  });
  std::fill(row_has_postponed_.begin(), row_has_postponed_.end(), no);
}

}  // namespace perimpact
