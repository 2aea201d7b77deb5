#include "perimpact/materials/ordinary_state/ordinary_state_force.hpp"

#include "base/parallel.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state_kernels.hpp"

namespace perimpact {

using namespace fccda;
using namespace ordinary_state;

namespace {

template <class Pack, bool has_dilatation, bool with_energy, class View, class Correction>
void all_packs(const View& body, const Particles& particles, Breaking& breaking, Family& family, const PassOptions& options, SumsOfEights& sums,
               const Correction& corrections) {
  PassOptions forces = options;
  if constexpr (has_dilatation) {
    PassOptions dilatations = options;
    dilatations.with_energy = false;
    breaking.for_each_pack<Pack>(body.bonds, particles, family, dilatations, sums, [&](std::size_t eight, std::size_t slot, const auto& breaker) {
      with_factors(body, slot, corrections, [&](const View& view, std::size_t at, const auto& factors) {
        dilatation_of_pack<Pack>(view, at, breaker, factors, sums.fracture_energy[eight]);
      });
      return 0.0;
    });
    particles.share().begin_refresh({body.theta});
    forces.may_break = false;  // bonds have broken in the dilatation pass
  }
  breaking.for_each_pack<Pack>(body.bonds, particles, family, forces, sums, [&](std::size_t eight, std::size_t slot, const auto& breaker) {
    return with_factors(body, slot, corrections, [&](const View& view, std::size_t at, const auto& factors) {
      return force_of_pack<Pack, has_dilatation, with_energy>(view, at, breaker, factors, sums.fracture_energy[eight]);
    });
  });
}

}  // namespace

CorrectionBasis basis_of(const OrdinaryState& law) {
  const FamilySums whole = law.whole_family();
  return {law.elastic().poissons_ratio,
          [law](double length) { return law.weights(length).dilatation; },
          [law](double length) { return law.weights(length).stretch; },
          whole.volume,
          whole.weighted,
          whole.dilatation,
          whole.energy};
}

OrdinaryStateForce::OrdinaryStateForce(OrdinaryState law, Breaking breaking, CorrectionFactors correction, const Family& family, const Particles& particles)
    : law_(law), breaking_(std::move(breaking)), correction_(std::move(correction)) {
  if (law_.needs_dilatation()) theta_ = ScalarArray(particles.slots(), particles.slack());
  if (const Stencil* stencil = family.stencil()) {
    for (const StencilBond& bond : stencil->bonds()) half_squares_.push_back(interpolation_weights(bond.direction));
    for (const std::vector<BondFactors>& factors : correction_.tables())
      for (std::size_t b = 0; b < stencil->size(); ++b) {
        const StencilBond& bond = stencil->bonds()[b];
        const BondWeights weights = law_.weights(bond.length);
        folded_.push_back(law_.fold(bond.length, factors[b].stretch * weights.stretch * bond.volume, factors[b].dilatation * weights.dilatation * bond.volume));
      }
    return;
  }
  const bool by_family = correction_.kind() == CorrectionKind::family;  // the kernel applies its factors, since it needs those of particles anyway
  stretch_.assign(family.list()->length.size(), 0.0);
  if (law_.needs_dilatation()) dilatation_ = stretch_;
  parallel_for(static_cast<std::ptrdiff_t>(particles.size()), [&](std::ptrdiff_t particle) {
    const std::size_t slot = particles.slot_of()[static_cast<std::size_t>(particle)];
    family.for_each_bond(slot, [&](const FamilyBond& bond) {
      const BondWeights weights = law_.weights(bond.length);
      const Vec3d interpolation = interpolation_weights(bond.direction);
      stretch_[bond.index] = weights.stretch * bond.volume * (by_family ? 1 : correction_.stretch_factor(slot, bond.j, interpolation));
      if (!dilatation_.empty()) dilatation_[bond.index] = weights.dilatation * bond.volume * correction_.dilatation_factor(slot, bond.j, interpolation);
    });
  });
}

template <class Pack>
void OrdinaryStateForce::pass(Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums) {
  const auto over = [&](const auto& body, const auto& corrections) {
    with_constant(law_.needs_dilatation(), [&](auto has_dilatation) {
      with_constant(options.with_energy,
                    [&](auto energy) { all_packs<Pack, has_dilatation.value, energy.value>(body, particles, breaking_, family, options, sums, corrections); });
    });
  };
  if (!family.list()) return with_view_of_lattice(particles, StencilBonds(family), family.offsets().size(), options.dt, over);
  const ListConstants constants{law_, family.list()->length.data(), stretch_.data(), law_.needs_dilatation() ? dilatation_.data() : stretch_.data()};
  const BodyView<ListedBonds, ListConstants> body{
      particles.view(),    ListedBonds(family), constants, correction_.table_of().data(), law_.a(), particles.force_density.writable_pointers(),
      theta_.component(0), options.dt};
  if (correction_.kind() == CorrectionKind::family)
    over(body, corrections_by_family());
  else
    over(body, NoCorrections{});  // the factors are in the constants
}

template void OrdinaryStateForce::pass<double>(Particles&, Family&, const PassOptions&, SumsOfEights&);
#if defined(__AVX2__) && !defined(FCCDA_SCALAR_PACK)
template void OrdinaryStateForce::pass<NativePack>(Particles&, Family&, const PassOptions&, SumsOfEights&);
#endif

StepMessages OrdinaryStateForce::messages() const {
  StepMessages messages = breaking_.messages();
  if (law_.needs_dilatation()) messages.refreshed.push_back(sizeof(double));  // θ
  return messages;
}

double OrdinaryStateForce::bytes() const {
  return correction_.bytes() + breaking_.bytes() + static_cast<double>(sizeof(double) * (theta_.slots() + stretch_.size() + dilatation_.size()));
}

}  // namespace perimpact
