#include "perimpact/force/breaking.hpp"

#include "fccda/core/parallel.hpp"

namespace perimpact {

Breaking::Breaking(const BreakingRule& rule, const std::vector<double>& strength, const Family& family, const Particles& particles) : rule_(rule) {
  if (const Stencil* stencil = family.stencil()) {
    for (const StencilBond& bond : stencil->bonds()) {
      const double limit = (1 + rule.stretch) * bond.length;
      squared_limits_.push_back(limit * limit);
      lengths_.push_back(bond.length);
    }
  }
  if (strength.empty() && !rule.compression && rule.hardening == 0) return;
  half_strength_ = ScalarArray(particles.slots(), particles.slack(), 0.5);
  for (std::size_t slot = 0; slot < strength.size(); ++slot) half_strength_.component(0)[slot] = 0.5 * strength[slot];
  if (rule.hardening > 0) first_half_strength_.assign(half_strength_.component(0), half_strength_.component(0) + particles.slots());
}

namespace {

/// s_min of the particles of a pack, at most 0.
template <class Pack, class Bonds, class Lengths>
Pack least_stretch(const Bonds& bonds, const Lengths& lengths, const std::array<const double*, 3>& x, std::size_t slot) {
  Pack most(0.0);  // 1 - |η + ξ|²/|ξ|², which grows as the stretch falls
  for_each_bond<Pack>(bonds, x, slot, Unbreakable{}, [&](const auto& bond) {
    const Pack length = lengths.template length<Pack>(bond.index);
    most = fccda::larger(most, fccda::keep_where(bond.intact, Pack(1.0) - bond.squared_length / (length * length)));
  });
  const Pack squared = fccda::larger(Pack(1.0) - most, Pack(1e-12));  // a bond without length is not squeezed further
  return squared * fccda::inverse_square_root(squared) - Pack(1.0);
}

}  // namespace

template <class Pack>
void Breaking::follow(const Particles& particles, Family& family) {
  if (first_half_strength_.empty()) return;
  const std::array<const double*, 3> x = particles.position.pointers();
  const Pack slope(-0.5 * rule_->hardening / rule_->stretch);
  double* half = half_strength_.component(0);
  const auto over = [&](const auto& bonds, const auto& lengths) {
    fccda::parallel_for(static_cast<std::ptrdiff_t>(particles.slots() / fccda::byte_lanes), [&](std::ptrdiff_t eight) {
      const std::size_t begin = static_cast<std::size_t>(eight) * fccda::byte_lanes;
      for (std::size_t slot = begin; slot < begin + fccda::byte_lanes; slot += fccda::lanes<Pack>)
        fccda::store(half + slot, fccda::fused(slope, least_stretch<Pack>(bonds, lengths, x, slot), fccda::load<Pack>(first_half_strength_.data() + slot)));
    });
  };
  if (family.list())
    over(ListedBonds(family), LengthOnList{family.list()->length.data()});
  else
    over(StencilBonds(family), LengthOnStencil{lengths_});
}

template void Breaking::follow<double>(const Particles&, Family&);
#if defined(__AVX2__) && !defined(FCCDA_SCALAR_PACK)
template void Breaking::follow<fccda::NativePack>(const Particles&, Family&);
#endif

}  // namespace perimpact
