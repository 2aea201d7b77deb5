#include "perimpact/materials/correspondence/correspondence_force.hpp"

#include <algorithm>
#include <limits>

#include "base/parallel.hpp"
#include "perimpact/materials/correspondence/bond_level_kernels.hpp"
#include "perimpact/materials/correspondence/one_point_kernels.hpp"

namespace perimpact {

using namespace fccda;
using namespace correspondence;

template <std::size_t D>
template <class Visit>
void CorrespondenceForce<D>::with_view(const ParticlesView& particles, const Vectors& force, Family& family, double dt, const Visit& visit) {
  const auto visit_with = [&](const auto& bonds, const auto& shapes) { visit(view(particles, force, bonds, bonds.with(known_.data()), shapes, dt)); };
  if (family.list())
    visit_with(ListedBonds(family), ListShapes{reference_.pointers(), listed_weighted_volume_.data()});
  else
    visit_with(StencilBonds(family), stencil_shapes());
}

template <std::size_t D>
CorrespondenceForce<D>::CorrespondenceForce(const Correspondence& law, Breaking breaking, Family& family, const Particles& particles)
    : law_(law),
      breaking_(std::move(breaking)),
      known_(family.begin(particles.slots() / byte_lanes), 0),
      shape_(particles.slots(), 0),
      bound_at_first_(particles.slots(), std::numeric_limits<double>::infinity()),
      response_(particles.slots(), particles.slack()) {
  EXPECTS(D == (particles.is_plane() ? 2 : 3));
  if (law_.is_bond_level()) {
    gradient_ = carried_ = SlotArray<D * D>(particles.slots(), particles.slack());
    if (breaking_.is_armed()) {
      rate_ = gradient_;
      broken_.assign(particles.slots() / byte_lanes, far_off);
    }
  }
  if (const Stencil* stencil = family.stencil()) {
    for (const StencilBond& bond : stencil->bonds()) {
      bonds_.push_back(bond.length * bond.direction);
      weighted_volume_.push_back(law_.weight(bond.length) * bond.volume);
    }
  } else {
    reference_ = VectorArray(particles.slots(), particles.slack());
    for (std::size_t slot = 0; slot < particles.slots(); ++slot) reference_.set(slot, particles.reference(slot));
    const BondList& list = *family.list();
    listed_weighted_volume_.resize(list.length.size());
    parallel_for(static_cast<std::ptrdiff_t>(list.length.size()), [&](std::ptrdiff_t number) {
      const auto entry = static_cast<std::size_t>(number);
      listed_weighted_volume_[entry] = law_.weight(list.length[entry]) * list.volume[entry];
    });
  }
  with_view(particles.view(), {}, family, 0, [&](const auto& body) {
    // packs of fewer lanes than a byte share bytes of known_: one thread takes all packs of a byte
    parallel_for(static_cast<std::ptrdiff_t>(particles.slots() / byte_lanes), [&](std::ptrdiff_t eight) {
      const std::size_t begin = static_cast<std::size_t>(eight) * byte_lanes;
      for (std::size_t slot = begin; slot < begin + byte_lanes; slot += lanes<NativePack>) follow_bonds<D, NativePack>(body, slot);
    });
  });
  particles.share().refresh({shape_.component(symmetric), shape_.component(symmetric + 1)});
  std::copy_n(shape_.component(symmetric + 1), particles.slots(), bound_at_first_.begin());  // here χ is 1, or 0 where the bound is 0
}

template <std::size_t D>
template <class Pack, class View>
[[gnu::noinline, gnu::cold]] void CorrespondenceForce<D>::account_for_broken(const View& body, const Particles& particles, const Family& family,
                                                                             SumsOfEights& sums) {
  const View before = body.before();
  // a broken bond changes F at its ends, and thus the energy of their families, which needs dF/dt of the families of these
  for (const std::uint8_t from : {broke_here, changed}) {
    const std::vector<std::uint8_t> of_ghosts = particles.share().refreshed_flags(broken_);
    const auto raise = [&](std::size_t slot) {
      std::uint8_t& of_j = broken_[slot / byte_lanes];
      of_j = std::max(of_j, static_cast<std::uint8_t>(from - 1));
    };
    particles.share().for_each_ghost([&](std::size_t ghost) {
      if (of_ghosts[ghost] < from) return;
      family.for_each_end_at_ghost(ghost, particles, [&](std::size_t i, std::size_t row) {
        if ((known_[family.begin(i / byte_lanes) + row] >> (i % byte_lanes)) & 1u) raise(i);
      });
    });
    for (std::size_t eight = 0; eight < broken_.size(); ++eight) {
      if (broken_[eight] < from) continue;
      for (std::size_t slot = eight * byte_lanes; slot < (eight + 1) * byte_lanes; slot += lanes<Pack>)
        for_each_bond<Pack>(before.bonds, body.particles.position, slot, Unbreakable{}, [&](const auto& bond) {
          for_each_bit(bond.intact, [&](std::size_t lane) {
            if (const std::size_t j = bond.neighbour.slot_of(lane); particles.owns(j)) raise(j);
          });
        });
    }
  }
  const auto for_each = [&](Nearness least, const auto& f) {
    for_each_pack<Pack>(particles, [&](std::size_t eight, std::size_t slot) {
      if (broken_[slot / byte_lanes] >= least) f(eight, slot);
    });
  };
  const auto add_energy = [&](const auto& view, double sign) {
    for_each(changed, [&](std::size_t eight, std::size_t slot) {
      sums.fracture_energy[eight] += sign * energy_of_pack(bond_level_energy<D, Pack, true>(view, slot), particles, slot);
    });
  };
  const auto refresh = [&](const auto& matrices) { particles.share().refresh(std::span<double* const>(matrices)); };
  for_each(broke_here, [&](std::size_t, std::size_t slot) { renew_gradient<D, Pack>(before, slot); });
  refresh(body.gradient);
  for_each(beside_changed, [&](std::size_t, std::size_t slot) { renew_rate<D, Pack>(before, slot); });
  refresh(body.rate);
  add_energy(before, 1);
  for_each(broke_here, [&](std::size_t, std::size_t slot) {
    follow_bonds<D, Pack>(body, slot);
    renew_gradient<D, Pack>(body, slot);
    renew_rate<D, Pack>(body, slot);
  });
  refresh(body.gradient);
  refresh(body.rate);
  particles.share().refresh({shape_.component(symmetric)});
  add_energy(body, -1);
  std::fill(broken_.begin(), broken_.end(), std::uint8_t{far_off});
}

template <std::size_t D>
template <class Pack, class View>
void CorrespondenceForce<D>::bond_level_pass(const View& body, Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums) {
  breaking_.template for_each_pack<Pack>(body.bonds, particles, family, options, sums, [&](std::size_t, std::size_t slot, const auto& breaker) {
    gradient_of_pack<D, Pack>(body, slot, breaker);
    return 0.0;
  });
  const Share& share = particles.share();
  share.refresh(std::span<double* const>(body.gradient));
  share.refresh({shape_.component(symmetric)});  // initial cracks change it too
  if (share.ranks().any(std::find(broken_.begin(), broken_.end(), broke_here) != broken_.end())) account_for_broken<Pack>(body, particles, family, sums);
  for_each_pack<Pack>(particles, [&](std::size_t eight, std::size_t slot) {
    bond_level_stress<D, Pack>(body, slot);
    if (options.with_energy) sums.energy[eight] += energy_of_pack(bond_level_energy<D, Pack, false>(body, slot), particles, slot);
  });
  share.begin_refresh(std::span<double* const>(body.carried));
  for_each_pack<Pack>(particles, [&](std::size_t, std::size_t slot) { bond_level_return<D, Pack>(body, slot); });
  share.begin_refresh(std::span<double* const>(body.response));
  for_each_pack<Pack>(particles, [&](std::size_t, std::size_t slot) { force_of_pack<D, Pack>(body, slot); });
}

template <std::size_t D>
template <class Pack>
void CorrespondenceForce<D>::pass(Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums) {
  with_view(particles.view(), particles.force_density.writable_pointers(), family, options.dt, [&](const auto& body) {
    if (law_.is_bond_level()) return bond_level_pass<Pack>(body, particles, family, options, sums);
    breaking_.template for_each_pack<Pack>(body.bonds, particles, family, options, sums, [&](std::size_t eight, std::size_t slot, const auto& breaker) {
      const Pack density = response_of_pack<D, Pack>(body, slot, breaker, options.with_energy, sums.fracture_energy[eight]);
      return options.with_energy ? energy_of_pack(density, particles, slot) : 0.0;
    });
    particles.share().begin_refresh(std::span<double* const>(body.response));
    for_each_pack<Pack>(particles, [&](std::size_t, std::size_t slot) { force_of_pack<D, Pack>(body, slot); });
  });
}

template <std::size_t D>
SmallMatrix<double, D> CorrespondenceForce<D>::inverse_shape(std::size_t slot) const {
  SmallMatrix<double, D> inverse;
  std::size_t n = 0;
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = r; s < D; ++s) inverse.m[r][s] = inverse.m[s][r] = shape_.component(n++)[slot];
  return inverse;
}

template <std::size_t D>
StepMessages CorrespondenceForce<D>::messages() const {
  StepMessages messages = breaking_.messages();
  if (law_.is_bond_level()) {
    messages.refreshed.push_back(D * D * sizeof(double));  // deformation gradient
    messages.refreshed.push_back(sizeof(double));          // χ
    messages.collectives += reduction_of(1);               // whether a bond has broken
    messages.refreshed.push_back(D * D * sizeof(double));  // stress carried to the bonds
  }
  messages.refreshed.push_back(loads * sizeof(double));
  return messages;
}

template <std::size_t D>
double CorrespondenceForce<D>::bytes() const {
  const std::size_t doubles = shape_.slots() * (symmetric + 3 + loads) + D * D * (gradient_.slots() + carried_.slots() + rate_.slots()) +
                              3 * reference_.slots() + listed_weighted_volume_.size();
  return breaking_.bytes() + static_cast<double>(sizeof(double) * doubles + known_.size() + broken_.size());
}

template class CorrespondenceForce<2>;
template class CorrespondenceForce<3>;
template void CorrespondenceForce<2>::pass<double>(Particles&, Family&, const PassOptions&, SumsOfEights&);
template void CorrespondenceForce<3>::pass<double>(Particles&, Family&, const PassOptions&, SumsOfEights&);
#if defined(__AVX2__) && !defined(FCCDA_SCALAR_PACK)
template void CorrespondenceForce<2>::pass<NativePack>(Particles&, Family&, const PassOptions&, SumsOfEights&);
template void CorrespondenceForce<3>::pass<NativePack>(Particles&, Family&, const PassOptions&, SumsOfEights&);
#endif

}  // namespace perimpact
