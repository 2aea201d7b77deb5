#include "perimpact/damage/breaking.hpp"

#include <utility>

#include "perimpact/damage/pressed_strength.hpp"

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
  const double slope = hardening_slope(*rule_);
  const double* first = half_strength_.slots() != 0 ? half_strength_.component(0) : nullptr;
  const auto over = [&](const auto& bonds, const auto& lengths) {
    fccda::parallel_for(static_cast<std::ptrdiff_t>(is_asked_.size()), [&](std::ptrdiff_t eight) {
      const auto at = static_cast<std::size_t>(eight);
      if (!std::exchange(is_asked_[at], no)) return;
      const std::size_t begin = at * fccda::byte_lanes;
      for (std::size_t slot = begin; slot < begin + fccda::byte_lanes; slot += fccda::lanes<Pack>) {
        fccda::store(pressed_half_strength_.component(0) + slot, half_strength_under_pressure<Pack>(bonds, lengths, x, slot, slope, first));
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
