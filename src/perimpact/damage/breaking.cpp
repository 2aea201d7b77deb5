#include "perimpact/damage/breaking.hpp"

#include <utility>

namespace perimpact {

Breaking::Breaking(const BreakingRule& rule, const std::vector<double>& strength, const Family& family, const Particles& particles) : rule_(rule) {
  if (const Stencil* stencil = family.stencil()) {
    for (const StencilBond& bond : stencil->bonds()) {
      const double limit = (1 + rule.stretch) * bond.length;
      squared_limits_.push_back(limit * limit);
      lengths_.push_back(bond.length);
    }
  }
  if (!strength.empty() || rule.compression) {
    half_strength_ = ScalarArray(particles.slots(), particles.slack(), 0.5);
    for (std::size_t slot = 0; slot < strength.size(); ++slot) half_strength_.component(0)[slot] = 0.5 * strength[slot];
    particles.share().refresh({half_strength_.component(0)});
  }
  if (rule.hardening == 0) return;
  pressed_half_strength_ = half_strength_.slots() != 0 ? half_strength_ : ScalarArray(particles.slots(), particles.slack(), 0.5);
  is_asked_.assign(particles.slots() / fccda::byte_lanes, no);
  postponed_.assign(particles.slots(), no);
  row_has_postponed_.assign(particles.rows(), no);
}

namespace {

/// Minimum bond stretch s_min of the particles of a pack, at most 0.
template <class Pack, class Bonds, class Lengths>
Pack least_stretch(const Bonds& bonds, const Lengths& lengths, const std::array<const double*, 3>& x, std::size_t slot) {
  Pack most(0.0);  // 1 - |η + ξ|²/|ξ|², which increases as the stretch decreases
  for_each_bond<Pack>(bonds, x, slot, Unbreakable{}, [&](const auto& bond) {
    const Pack length = lengths.template length<Pack>(bond.index);
    most = fccda::larger(most, fccda::select(bond.intact, Pack(1.0) - bond.squared_length / (length * length)));
  });
  const Pack squared = fccda::larger(Pack(1.0) - most, Pack(1e-12));  // lower bound for bonds of zero length
  return squared * fccda::inverse_square_root(squared) - Pack(1.0);
}

}  // namespace

void Breaking::pass_requests(const Share& share) {
  std::vector<std::uint8_t> of_slots(is_asked_.size() * fccda::byte_lanes, no);
  share.for_each_ghost([&](std::size_t slot) { of_slots[slot] = is_asked_[slot / fccda::byte_lanes]; });
  share.collect_flags(of_slots.data());
  for (std::size_t slot = 0; slot < of_slots.size(); ++slot)
    if (of_slots[slot] != no) is_asked_[slot / fccda::byte_lanes] = yes;
}

template <class Pack>
void Breaking::find_pressed_strength(const Particles& particles, Family& family) {
  const std::array<const double*, 3> x = particles.position.pointers();
  const Pack slope(-0.5 * rule_->hardening / rule_->stretch);
  const double* first = half_strength_.slots() != 0 ? half_strength_.component(0) : nullptr;
  const auto over = [&](const auto& bonds, const auto& lengths) {
    fccda::parallel_for(static_cast<std::ptrdiff_t>(is_asked_.size()), [&](std::ptrdiff_t eight) {
      const auto at = static_cast<std::size_t>(eight);
      if (!std::exchange(is_asked_[at], no)) return;
      const std::size_t begin = at * fccda::byte_lanes;
      for (std::size_t slot = begin; slot < begin + fccda::byte_lanes; slot += fccda::lanes<Pack>) {
        const Pack unpressed = first ? fccda::load<Pack>(first + slot) : Pack(0.5);
        fccda::store(pressed_half_strength_.component(0) + slot, fccda::fused_multiply_add(slope, least_stretch<Pack>(bonds, lengths, x, slot), unpressed));
      }
    });
  };
  if (family.list())
    over(ListedBonds(family), lengths<ListedBonds>(family));
  else
    over(StencilBonds(family), lengths<StencilBonds>(family));
}

template void Breaking::find_pressed_strength<double>(const Particles&, Family&);
#if defined(__AVX2__) && !defined(FCCDA_SCALAR_PACK)
template void Breaking::find_pressed_strength<fccda::NativePack>(const Particles&, Family&);
#endif

}  // namespace perimpact
