#include "perimpact/materials/ordinary_state/ordinary_state_force.hpp"

#include "base/parallel.hpp"
#include "perimpact/force/bond_loop.hpp"
#include "perimpact/force/correction_kernels.hpp"

namespace perimpact {

using namespace fccda;

namespace {

/// Constants of the bonds of a stencil: those of complete families, and one set for each further table of factors.
struct StencilConstants {
  std::span<const OrdinaryState::Folded<double>> folded;  // table after table
  std::size_t bonds;

  StencilConstants of_table(std::int32_t table) const { return {folded.subspan(static_cast<std::size_t>(table) * bonds), bonds}; }

  template <class Pack>
  const OrdinaryState::Folded<double>& constants(std::size_t index) const {
    return folded[index];
  }
};

/// The same for the bonds of a list.
struct ListConstants {
  const OrdinaryState& law;
  const double *length, *stretch, *dilatation;

  ListConstants of_table(std::int32_t) const { return *this; }
  template <class Pack>
  OrdinaryState::Folded<Pack> constants(std::size_t index) const {
    return law.fold(load<Pack>(length + index), load<Pack>(stretch + index), load<Pack>(dilatation + index));
  }
};

/// Data that the passes over one body read and write.
template <class Bonds, class Constants>
struct BodyView {
  const Particles& particles;
  std::array<const double*, 3> x;
  VectorArray& force;
  double* theta;
  Bonds bonds;
  Constants constants;
  const CorrectionFactors& correction;
  const OrdinaryState& law;
  SumsOfEights& sums;
  double dt;  // [s], as in PassOptions

  BodyView with(const Constants& others) const { return {particles, x, force, theta, bonds, others, correction, law, sums, dt}; }
};

/// Relative velocity y_j' - y_i' [m/s] of the bonds of a pack.
template <class Pack, class View, class Bond>
Vec3<Pack> relative_velocity(const View& body, std::size_t slot, const Bond& bond) {
  const std::array<const double*, 3> v = body.particles.velocity.pointers();
  return {bond.neighbour.of(v[0]) - load<Pack>(v[0] + slot), bond.neighbour.of(v[1]) - load<Pack>(v[1] + slot),
          bond.neighbour.of(v[2]) - load<Pack>(v[2] + slot)};
}

/// Stretch energy of bonds that just broke, in the middle of the step, u - dt u'/2 [J], at this end, summed over the lanes in `bond.intact`.
template <class Pack, class View, class Bond, class Correction>
[[gnu::noinline, gnu::cold]] double released_energy(const View& body, std::size_t slot, const Bond& bond, const Correction& correction) {
  const auto& folded = body.constants.template constants<Pack>(bond.index);
  const Pack inverse_length = inverse_square_root(bond.squared_length);
  const Pack pull = OrdinaryState::stretch_force(folded, inverse_length);  // the ends share the energy of a bond, and thus the power of its force
  const Pack rate = Pack(0.5) * pull * dot(bond.between, relative_velocity<Pack>(body, slot, bond));
  const Pack released = OrdinaryState::stretch_energy(folded, bond.squared_length * inverse_length) - Pack(0.5 * body.dt) * rate;
  const Pack density = correction.stretch.corrected(released, correction.stretch.template of<Pack>(slot), bond.index, bond.neighbour);
  return energy_of_pack(select(bond.intact, density), body.particles, slot);
}

/// Contribution of the bonds of a pack to the rate of θ [1/s].
template <class Pack, class View, class Bond>
Pack dilatation_rate(const View& body, std::size_t slot, const Bond& bond) {
  return Pack(body.constants.template constants<Pack>(bond.index).theta_slope) * inverse_square_root(bond.squared_length) *
         dot(bond.between, relative_velocity<Pack>(body, slot, bond));
}

/// Dilatation energy released by the particles of a pack: a θ² - dt (a θ²)'/2 before failure, less the same after it [J]. `gone` [-], `gone_rate` [1/s]:
/// contributions of the broken bonds to the sum θ and its rate; `sum`: that of the remaining bonds.
template <class Pack, class View, class Correction>
[[gnu::noinline, gnu::cold]] double released_dilatation_energy(const View& body, std::size_t slot, Pack sum, Pack gone, Pack gone_rate,
                                                               const Correction& correction) {
  const auto of_i = correction.dilatation.template of<Pack>(slot);
  Pack rate(0.0);
  for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{}, [&](const auto& bond) {
    const Pack slope = dilatation_rate<Pack>(body, slot, bond);
    rate += select(bond.intact, correction.dilatation.corrected(slope, of_i, bond.index, bond.neighbour));
  });
  const auto density = [&](Pack of_sum, Pack of_rate) {
    const Pack theta = correction.dilatation_of(correction.pushing(of_sum, slot), slot),
               change = correction.dilatation_of(correction.pushing(of_rate, slot), slot);
    return body.law.dilatation_energy(theta) - Pack(body.dt * body.law.a()) * theta * change;
  };
  return energy_of_pack(density(sum + gone, rate + gone_rate) - density(sum, rate), body.particles, slot);
}

/// θ of the particles of one pack. Adds the released energy to `fracture` [J].
template <class Pack, class View, class Breaker, class Correction>
void dilatation_of_pack(const View& body, std::size_t slot, const Breaker& breaking, const Correction& correction, double& fracture) {
  const auto of_i = correction.dilatation.template of<Pack>(slot);
  const auto term_of = [&](const auto& bond) {
    const Pack term = OrdinaryState::dilatation(body.constants.template constants<Pack>(bond.index), length_of(bond.squared_length));
    return select(bond.intact, correction.dilatation.corrected(term, of_i, bond.index, bond.neighbour));
  };
  Pack theta(0.0);
  [[maybe_unused]] Pack gone(0.0), gone_rate(0.0);
  [[maybe_unused]] bool broke = false;
  for_each_bond<Pack>(
      body.bonds, body.x, slot, breaking, [&](const auto& bond) { theta += term_of(bond); },
      [&](const auto& bond) {
        fracture += released_energy<Pack>(body, slot, bond, correction);
        gone += term_of(bond);
        gone_rate += select(bond.intact, correction.dilatation.corrected(dilatation_rate<Pack>(body, slot, bond), of_i, bond.index, bond.neighbour));
        broke = true;
      });
  if constexpr (Breaker::is_armed)
    if (broke) [[unlikely]]
      fracture += released_dilatation_energy(body, slot, theta, gone, gone_rate, correction);
  store(body.theta + slot, correction.pushing(theta, slot));
}

/// Force density of the particles of one pack; returns their total energy [J] if with_energy. Adds the released energy to `fracture` [J].
template <class Pack, bool has_dilatation, bool with_energy, class View, class Breaker, class Correction>
double force_of_pack(const View& body, std::size_t slot, const Breaker& breaking, const Correction& correction, double& fracture) {
  const auto stretch_of_i = correction.stretch.template of<Pack>(slot);
  const auto dilatation_of_i = correction.dilatation.template of<Pack>(slot);
  const Pack theta_i = has_dilatation ? load<Pack>(body.theta + slot) : Pack(0.0);
  Vec3<Pack> force{Pack(0.0), Pack(0.0), Pack(0.0)};
  Pack energy(0.0);
  const auto add = [&](const auto& bond) {
    const auto& folded = body.constants.template constants<Pack>(bond.index);
    const Pack inverse_length = inverse_square_root(bond.squared_length);
    Pack pull = correction.stretch.corrected(OrdinaryState::stretch_force(folded, inverse_length), stretch_of_i, bond.index, bond.neighbour);
    if constexpr (has_dilatation) {
      const Pack push = OrdinaryState::dilatation_force(folded, theta_i, bond.neighbour.of(body.theta));
      pull = fused_multiply_add(correction.dilatation.corrected(push, dilatation_of_i, bond.index, bond.neighbour), inverse_length, pull);
    }
    pull = select(bond.intact, pull);
    force.x = fused_multiply_add(pull, bond.between.x, force.x);
    force.y = fused_multiply_add(pull, bond.between.y, force.y);
    force.z = fused_multiply_add(pull, bond.between.z, force.z);
    if constexpr (with_energy) {
      const Pack stored = OrdinaryState::stretch_energy(folded, bond.squared_length * inverse_length);
      energy += select(bond.intact, correction.stretch.corrected(stored, stretch_of_i, bond.index, bond.neighbour));
    }
  };
  for_each_bond<Pack>(body.bonds, body.x, slot, breaking, add, [&](const auto& bond) { fracture += released_energy<Pack>(body, slot, bond, correction); });
  store(body.force.component(0) + slot, force.x);
  store(body.force.component(1) + slot, force.y);
  store(body.force.component(2) + slot, force.z);
  if constexpr (with_energy && has_dilatation) energy += body.law.dilatation_energy(correction.dilatation_of(theta_i, slot));
  return with_energy ? energy_of_pack(energy, body.particles, slot) : 0.0;
}

template <class Pack, bool has_dilatation, bool with_energy, class View, class Correction>
void all_packs(const View& body, Breaking& breaking, Family& family, const PassOptions& options, const Correction& corrections) {
  PassOptions forces = options;
  if constexpr (has_dilatation) {
    PassOptions dilatations = options;
    dilatations.with_energy = false;
    breaking.for_each_pack<Pack>(body.bonds, body.particles, family, dilatations, body.sums, [&](std::size_t eight, std::size_t slot, const auto& breaker) {
      with_factors(body, slot, corrections, [&](const View& view, std::size_t at, const auto& factors) {
        dilatation_of_pack<Pack>(view, at, breaker, factors, body.sums.fracture_energy[eight]);
      });
      return 0.0;
    });
    body.particles.share().refresh({body.theta});
    forces.may_break = false;  // bonds have broken in the dilatation pass
  }
  breaking.for_each_pack<Pack>(body.bonds, body.particles, family, forces, body.sums, [&](std::size_t eight, std::size_t slot, const auto& breaker) {
    return with_factors(body, slot, corrections, [&](const View& view, std::size_t at, const auto& factors) {
      return force_of_pack<Pack, has_dilatation, with_energy>(view, at, breaker, factors, body.sums.fracture_energy[eight]);
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
  const auto over = [&](const auto& bonds, const auto& constants, const auto& corrections) {
    using Bonds = std::decay_t<decltype(bonds)>;
    const BodyView<Bonds, std::decay_t<decltype(constants)>> body{
        particles, particles.position.pointers(), particles.force_density, theta_.component(0), bonds, constants, correction_, law_, sums, options.dt};
    with_constant(law_.needs_dilatation(), [&](auto has_dilatation) {
      with_constant(options.with_energy,
                    [&](auto energy) { all_packs<Pack, has_dilatation.value, energy.value>(body, breaking_, family, options, corrections); });
    });
  };
  const double* half = correction_.own_family().component(0);
  const FamilyFactor own{half};
  const Corrections<FamilyFactor, PlainBonds, true> by_family{own, {}, half};
  if (family.list()) {
    const ListConstants constants{law_, family.list()->length.data(), stretch_.data(), law_.needs_dilatation() ? dilatation_.data() : stretch_.data()};
    if (correction_.kind() == CorrectionKind::family)
      over(ListedBonds(family), constants, by_family);
    else
      over(ListedBonds(family), constants, NoCorrections{});  // the factors are in the constants
    return;
  }
  const StencilBonds bonds(family);
  const StencilConstants constants{folded_, family.stencil()->size()};
  if (correction_.kind() == CorrectionKind::family)
    over(bonds, constants, by_family);
  else
    with_bond_corrections(correction_, half_squares_, [&](const auto& corrections) { over(bonds, constants, corrections); });
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
