#include "perimpact/materials/ordinary_state/plastic_force.hpp"

#include <atomic>
#include <utility>

#include "base/parallel.hpp"
#include "perimpact/damage/strength.hpp"
#include "perimpact/force/bond_loop.hpp"
#include "perimpact/force/correction_kernels.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state_force.hpp"

namespace perimpact {

using namespace fccda;

namespace {

template <class Pack>
using PackTensor = std::array<Pack, 6>;

/// ½ n·A·n of a tensor A, as factors of its components.
template <class Number>
std::array<Number, 6> projection_of(const Vec3<Number>& n) {
  const Number half(0.5);
  return {half * n.x * n.x, half * n.y * n.y, half * n.z * n.z, n.x * n.y, n.y * n.z, n.x * n.z};
}

/// The constants of the bonds of a stencil: those of whole families, and of any other table of factors.
struct StencilConstants {
  std::span<const PlasticForce::Constants<double>> all;  // table after table
  std::span<const SymmetricTensor> projections;

  StencilConstants of_table(std::int32_t table) const { return {all.subspan(static_cast<std::size_t>(table) * projections.size()), projections}; }

  template <class Pack>
  const PlasticForce::Constants<double>& constants(std::size_t index) const {
    return all[index];
  }
  template <class Pack>
  const SymmetricTensor& projection(std::size_t index) const {
    return projections[index];
  }
};

/// Those of the bonds of a list.
struct ListConstants {
  const OrdinaryState& law;
  const double *length, *stretch, *dilatation;
  std::array<const double*, 3> direction;

  ListConstants of_table(std::int32_t) const { return *this; }
  template <class Pack>
  PlasticForce::Constants<Pack> constants(std::size_t index) const {
    return PlasticForce::constants(law, load<Pack>(length + index), load<Pack>(stretch + index), load<Pack>(dilatation + index));
  }
  template <class Pack>
  PackTensor<Pack> projection(std::size_t index) const {
    return projection_of(Vec3<Pack>{load<Pack>(direction[0] + index), load<Pack>(direction[1] + index), load<Pack>(direction[2] + index)});
  }
};

/// What all passes over one body read and write.
template <class Bonds, class BondConstants>
struct BodyView {
  const Particles& particles;
  std::array<const double*, 3> x;
  Bonds bonds;
  BondConstants constants;
  const CorrectionFactors& correction;
  const OrdinaryState& law;
  std::array<const double*, 6> strain, increment;
  const double *pressure, *pressure_slope, *resistance;
  double* theta;
  double dt;  // [s], as in PassOptions

  BodyView with(const BondConstants& others) const {
    return {particles, x, bonds, others, correction, law, strain, increment, pressure, pressure_slope, resistance, theta, dt};
  }
};

/// Bond strains of a pack of particles; `is_plastic`: where one of their bonds has a plastic strain.
template <class Pack, bool is_plastic, class View>
class Strains {
 public:
  Strains(const View& body, std::size_t slot) : body_(body) {
    if constexpr (is_plastic)
      for (std::size_t c = 0; c < 6; ++c) own_[c] = load<Pack>(body.strain[c] + slot);
  }

  /// s_e; bitwise equal at both ends, and with and without `is_plastic` where no strain is plastic.
  template <class Neighbour>
  Pack of(std::size_t index, Pack squared_length, const Neighbour& neighbour) const {
    const Pack total = fused_multiply_add(squared_length, Pack(body_.constants.template constants<Pack>(index).half_inverse), Pack(-0.5));
    if constexpr (!is_plastic) return total;
    return total - projected(body_.constants.template projection<Pack>(index), own_, body_.strain, neighbour);
  }

  /// ½ n·(A_i + A_j)·n
  template <class Projection, class Neighbour>
  static Pack projected(const Projection& projection, const PackTensor<Pack>& own, const std::array<const double*, 6>& of_all, const Neighbour& neighbour) {
    Pack sum = Pack(projection[0]) * (own[0] + neighbour.of(of_all[0]));
    for (std::size_t c = 1; c < 6; ++c) sum = fused_multiply_add(Pack(projection[c]), own[c] + neighbour.of(of_all[c]), sum);
    return sum;
  }

 private:
  const View& body_;
  PackTensor<Pack> own_;
};

/// Breaks bonds of a pack of particles whose strain is beyond their limit.
template <class Pack, bool is_plastic, class View>
struct BreakUnderPressure {
  static constexpr bool is_armed = true;
  const View& body;
  const Strains<Pack, is_plastic, View>& strains;
  Pack resistance, pressure, slope;  // of the pack itself
  BeyondLimit beyond;

  BreakUnderPressure(const View& view, const Strains<Pack, is_plastic, View>& its_strains, std::size_t slot, const BeyondLimit& what)
      : body(view),
        strains(its_strains),
        resistance(load<Pack>(view.resistance + slot)),
        pressure(load<Pack>(view.pressure + slot)),
        slope(load<Pack>(view.pressure_slope + slot)),
        beyond(what) {}
  template <class P>
  P of(std::size_t) const {
    return P(0.0);
  }
  template <class Neighbour>
  unsigned bits(std::size_t index, Pack squared_length, Pack, const Neighbour& j) const {
    const Pack squeezed = larger(pressure + j.of(body.pressure), Pack(0.0));
    const Pack limit = fused_multiply_add(slope + j.of(body.pressure_slope), squeezed, resistance + j.of(body.resistance));
    return bits_where_greater(strains.of(index, squared_length, j), limit);
  }
};

/// s_e of the bonds of a pack at the step before.
template <class Pack, class View, class Bond>
Pack strain_before(const View& body, std::size_t slot, const Bond& bond, Pack strain) {
  if (body.dt == 0) return strain;
  const std::array<const double*, 3> v = body.particles.velocity.pointers();
  const std::array<Pack, 3> between{bond.between.x, bond.between.y, bond.between.z};
  Pack gained(0.0);  // of |y|²
  for (std::size_t c = 0; c < 3; ++c) {
    const Pack way = Pack(body.dt) * (bond.neighbour.of(v[c]) - load<Pack>(v[c] + slot));
    gained = fused_multiply_add(way, between[c] + between[c] - way, gained);
  }
  const Pack half_inverse(body.constants.template constants<Pack>(bond.index).half_inverse);
  PackTensor<Pack> own;
  for (std::size_t c = 0; c < 6; ++c) own[c] = load<Pack>(body.increment[c] + slot);
  const Pack flowed = Strains<Pack, true, View>::projected(body.constants.template projection<Pack>(bond.index), own, body.increment, bond.neighbour);
  return strain - half_inverse * gained + flowed;
}

/// What bonds that just broke held in the middle of the step [J] at this end, ¼ k |ξ|² s_n s_{n+1}, summed over the lanes that `bond.intact` names.
template <class Pack, class View, class Bond, class Correction>
[[gnu::noinline, gnu::cold]] double released_energy(const View& body, std::size_t slot, const Bond& bond, Pack strain, const Correction& correction) {
  const auto& constants = body.constants.template constants<Pack>(bond.index);
  const Pack held = Pack(0.25) * Pack(constants.spring) * Pack(constants.squared) * strain * strain_before<Pack>(body, slot, bond, strain);
  const Pack density = correction.stretch.corrected(held, correction.stretch.template of<Pack>(slot), bond.index, bond.neighbour);
  return energy_of_pack(select(bond.intact, density), body.particles, slot);
}

/// Calls for_each_bond with the breaker of the pack where bonds may break.
template <class Pack, bool is_plastic, bool may_break, class View, class PerBond, class PerBroken>
void over_bonds(const View& body, const Strains<Pack, is_plastic, View>& strains, std::size_t slot, const BeyondLimit& beyond, const PerBond& per_bond,
                const PerBroken& per_broken) {
  if constexpr (may_break)
    for_each_bond<Pack>(body.bonds, body.x, slot, BreakUnderPressure<Pack, is_plastic, View>(body, strains, slot, beyond), per_bond, per_broken);
  else
    for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{}, per_bond);
}

/// Elastic dilatation of the particles of one pack. Adds to `fracture` [J].
template <class Pack, bool is_plastic, bool may_break, class View, class Correction>
void dilatation_of_pack(const View& body, std::size_t slot, const BeyondLimit& beyond, const Correction& correction, double& fracture) {
  const Strains<Pack, is_plastic, View> strains(body, slot);
  const auto of_i = correction.dilatation.template of<Pack>(slot);
  const auto term_of = [&](const auto& bond, Pack strain) {
    const Pack term = Pack(body.constants.template constants<Pack>(bond.index).dilatation) * strain;
    return select(bond.intact, correction.dilatation.corrected(term, of_i, bond.index, bond.neighbour));
  };
  const auto strain_of = [&](const auto& bond) { return strains.of(bond.index, bond.squared_length, bond.neighbour); };
  Pack theta(0.0);
  [[maybe_unused]] Pack gone(0.0), gone_before(0.0);
  [[maybe_unused]] bool broke = false;
  over_bonds<Pack, is_plastic, may_break>(
      body, strains, slot, beyond, [&](const auto& bond) { theta += term_of(bond, strain_of(bond)); },
      [&](const auto& bond) {
        const Pack strain = strain_of(bond);
        fracture += released_energy<Pack>(body, slot, bond, strain, correction);
        gone += term_of(bond, strain);
        gone_before += term_of(bond, strain_before<Pack>(body, slot, bond, strain));
        broke = true;
      });
  if constexpr (may_break)
    if (broke) [[unlikely]] {
      Pack before(0.0);
      for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{},
                          [&](const auto& bond) { before += term_of(bond, strain_before<Pack>(body, slot, bond, strain_of(bond))); });
      const Pack density = Pack(body.law.a()) * ((theta + gone) * (before + gone_before) - theta * before);
      fracture += energy_of_pack(density, body.particles, slot);
    }
  store(body.theta + slot, theta);
}

/// What a pass asks of the packs of a body, and where the results of one go.
template <class Pack>
struct OfPack {
  Vec3<Pack> force;
  Pack energy;    // [J/m³]
  Pack pressure;  // [Pa]
};

/// Force density, energy and pressure of the particles of one pack; with_stress: writes their stress too.
template <class Pack, bool is_plastic, bool has_dilatation, bool may_break, bool with_stress, class View, class Correction>
OfPack<Pack> force_of_pack(const View& body, std::size_t slot, const BeyondLimit& beyond, const Correction& correction, double& fracture,
                           std::array<double*, 6> stress) {
  const Strains<Pack, is_plastic, View> strains(body, slot);
  const auto stretch_of_i = correction.stretch.template of<Pack>(slot);
  [[maybe_unused]] const auto dilatation_of_i = correction.dilatation.template of<Pack>(slot);
  [[maybe_unused]] const Pack theta_i = has_dilatation ? load<Pack>(body.theta + slot) : Pack(0.0);
  Vec3<Pack> force{Pack(0.0), Pack(0.0), Pack(0.0)};
  Pack work(0.0), virial(0.0);
  [[maybe_unused]] PackTensor<Pack> sums{};
  const auto add = [&](const auto& bond) {
    const auto& constants = body.constants.template constants<Pack>(bond.index);
    const Pack strain = strains.of(bond.index, bond.squared_length, bond.neighbour);
    Pack pull = correction.stretch.corrected(Pack(constants.spring) * strain, stretch_of_i, bond.index, bond.neighbour);
    pull = select(bond.intact, pull);
    const Pack squared(constants.squared);
    work = fused_multiply_add(pull * squared, strain, work);
    if constexpr (has_dilatation) {
      const Pack push = Pack(constants.push) * (theta_i + bond.neighbour.of(body.theta));
      pull += select(bond.intact, correction.dilatation.corrected(push, dilatation_of_i, bond.index, bond.neighbour));
    }
    force.x = fused_multiply_add(pull, bond.between.x, force.x);
    force.y = fused_multiply_add(pull, bond.between.y, force.y);
    force.z = fused_multiply_add(pull, bond.between.z, force.z);
    if constexpr (with_stress) {
      const auto& projection = body.constants.template projection<Pack>(bond.index);
      const Pack power = pull * squared;
      for (std::size_t c = 0; c < 6; ++c) sums[c] = fused_multiply_add(power, Pack(projection[c]), sums[c]);
    }
    virial = fused_multiply_add(pull, squared, virial);
  };
  over_bonds<Pack, is_plastic, may_break>(body, strains, slot, beyond, add, [&](const auto& bond) {
    fracture += released_energy<Pack>(body, slot, bond, strains.of(bond.index, bond.squared_length, bond.neighbour), correction);
  });
  if constexpr (with_stress)
    for (std::size_t c = 0; c < 6; ++c) store(stress[c] + slot, c < 3 ? sums[c] : Pack(0.5) * sums[c]);
  Pack energy = Pack(0.25) * work;
  if constexpr (has_dilatation) energy += body.law.dilatation_energy(theta_i);
  return {force, energy, Pack(-1.0 / 6) * virial};
}

constexpr double yields_before_it_breaks = 1e30;  // [1/Pa] slope of the limit of particles that have yielded: no bond breaks under pressure

}  // namespace

ReturnModuli return_moduli(const OrdinaryState& law, const Stencil* stencil) {
  if (!stencil) return {law.elastic().bulk_modulus(), law.elastic().shear_modulus(), law.elastic().shear_modulus()};
  double c11 = 0, c12 = 0;  // C44 = C12 of bonds alone (Cauchy)
  for (const StencilBond& bond : stencil->bonds()) {
    const double k = 2 * law.b() * law.weights(bond.length).stretch * bond.volume, x = bond.direction.x * bond.direction.x;
    c11 += k * x * x, c12 += k * x * bond.direction.y * bond.direction.y;
  }
  return {(c11 + 2 * c12) / 3 + 2 * law.a(), (c11 - c12) / 2, c12};
}

PlasticForce::PlasticForce(OrdinaryState law, const Plasticity& plasticity, const std::optional<BreakingRule>& rule, const std::vector<double>& strength,
                           CorrectionFactors correction, const Family& family, const Particles& particles)
    : law_(law),
      plasticity_(plasticity),
      moduli_(return_moduli(law, family.stencil())),
      elastic_limit_(0.25 * plasticity.ellipse.a0 / std::max(moduli_.axial_shear, moduli_.plane_shear)),
      largest_pressure_(plasticity.ellipse.largest_pressure()),
      correction_(std::move(correction)) {
  if (rule) breaking_ = Breaking(*rule, {}, family, particles);
  const std::size_t slots = particles.slots(), slack = particles.slack();
  strain_ = increment_ = stress_ = TensorArray(slots, slack);
  equivalent_ = pressure_ = latest_pressure_ = ScalarArray(slots, slack);
  pressure_slope_ = ScalarArray(slots, slack, 3.0 / (16 * law.elastic().youngs_modulus));
  // s of the length (1 + s_c) |ξ|
  const double limit = rule ? rule->stretch + 0.5 * rule->stretch * rule->stretch : unbreakable;
  resistance_ = ScalarArray(slots, slack, 0.5 * limit);
  for (std::size_t slot = 0; slot < strength.size(); ++slot) resistance_.component(0)[slot] = 0.5 * limit * strength[slot];
  if (law_.needs_dilatation()) theta_ = ScalarArray(slots, slack);
  has_failed_.assign(slots, 0);
  is_plastic_.assign(slots / byte_lanes, 0);
  is_hot_.assign(slots / byte_lanes, 0);
  dissipation_.assign(particles.rows(), 0);
  pending_ = dissipation_;

  if (const Stencil* stencil = family.stencil()) {
    for (const StencilBond& bond : stencil->bonds()) {
      half_squares_.push_back(interpolation_weights(bond.direction));
      projection_.push_back(projection_of(bond.direction));
    }
    for (const std::vector<BondFactors>& factors : correction_.tables())
      for (std::size_t b = 0; b < stencil->size(); ++b) {
        const StencilBond& bond = stencil->bonds()[b];
        const BondWeights weights = law_.weights(bond.length);
        constants_.push_back(
            constants(law_, bond.length, factors[b].stretch * weights.stretch * bond.volume, factors[b].dilatation * weights.dilatation * bond.volume));
      }
    return;
  }
  const std::size_t entries = family.list()->length.size();
  stretch_.assign(entries, 0.0);
  dilatation_.assign(entries, 0.0);
  direction_ = VectorArray(entries, 0);
  parallel_for(static_cast<std::ptrdiff_t>(particles.size()), [&](std::ptrdiff_t particle) {
    const std::size_t slot = particles.slot_of()[static_cast<std::size_t>(particle)];
    family.for_each_bond(slot, [&](const FamilyBond& bond) {
      const BondWeights weights = law_.weights(bond.length);
      const Vec3d interpolation = interpolation_weights(bond.direction);
      stretch_[bond.index] = weights.stretch * bond.volume * correction_.stretch_factor(slot, bond.j, interpolation);
      dilatation_[bond.index] = weights.dilatation * bond.volume * correction_.dilatation_factor(slot, bond.j, interpolation);
      direction_.set(bond.index, bond.direction);
    });
  });
}

template <class Pack>
void PlasticForce::pass(Particles& particles, Family& family, const PassOptions& options, RowSums& rows) {
  const auto all_packs = [&](const auto& body, const auto& corrections, auto has_dilatation, auto may_break) {
    constexpr bool with_theta = decltype(has_dilatation)::value, breaks = decltype(may_break)::value;
    if constexpr (with_theta)
      for_each_pack<Pack>(particles, [&](std::size_t row, std::size_t slot) {
        const BeyondLimit beyond{&rows.broken_ends[row]};
        with_factors(body, slot, corrections, [&](const auto& view, std::size_t at, const auto& factors) {
          with_constant(is_plastic_[at / byte_lanes] != 0, [&](auto plastic) {
            dilatation_of_pack<Pack, decltype(plastic)::value, breaks>(view, at, beyond, factors, rows.fracture_energy[row]);
          });
        });
      });
    if (options.with_energy) std::fill(rows.energy.begin(), rows.energy.end(), 0.0);
    std::array<double*, 6> stress;
    for (std::size_t c = 0; c < 6; ++c) stress[c] = stress_.component(c);
    for_each_pack<Pack>(particles, [&](std::size_t row, std::size_t slot) {
      const BeyondLimit beyond{&rows.broken_ends[row]};
      double& fracture = rows.fracture_energy[row];
      constexpr bool breaks_here = breaks && !with_theta;  // the pass before has broken what breaks
      std::uint8_t& hot = is_hot_[slot / byte_lanes];
      const std::size_t first = slot % byte_lanes;
      if (first == 0) hot = 0;
      const auto heat = [&] { hot = static_cast<std::uint8_t>(hot | (((1u << lanes<Pack>)-1u) << first)); };
      const OfPack<Pack> of = with_factors(body, slot, corrections, [&](const auto& view, std::size_t at, const auto& factors) {
        if (with_theta || is_plastic_[at / byte_lanes]) {
          heat();
          if (is_plastic_[at / byte_lanes]) return force_of_pack<Pack, true, with_theta, breaks_here, true>(view, at, beyond, factors, fracture, stress);
          return force_of_pack<Pack, false, with_theta, breaks_here, true>(view, at, beyond, factors, fracture, stress);
        }
        const OfPack<Pack> elastic = force_of_pack<Pack, false, with_theta, breaks_here, false>(view, at, beyond, factors, fracture, stress);
        if (bits_where_greater(elastic.energy, Pack(elastic_limit_)) != 0) {
          heat();
          force_of_pack<Pack, false, with_theta, false, true>(view, at, beyond, factors, fracture, stress);
        }
        return elastic;
      });
      for (std::size_t c = 0; c < 3; ++c) store(particles.force_density.component(c) + slot, of.force[c]);
      if (options.may_break) store(latest_pressure_.component(0) + slot, of.pressure);
      if (options.with_energy) rows.energy[row] += energy_of_pack(of.energy, particles, slot);
    });
  };
  const auto over = [&](const auto& bonds, const auto& constants, const auto& corrections) {
    using Bonds = std::decay_t<decltype(bonds)>;
    const BodyView<Bonds, std::decay_t<decltype(constants)>> body{particles,
                                                                  particles.position.pointers(),
                                                                  bonds,
                                                                  constants,
                                                                  correction_,
                                                                  law_,
                                                                  std::as_const(strain_).pointers(),
                                                                  std::as_const(increment_).pointers(),
                                                                  pressure_.component(0),
                                                                  pressure_slope_.component(0),
                                                                  resistance_.component(0),
                                                                  theta_.component(0),
                                                                  options.dt};
    with_constant(law_.needs_dilatation(), [&](auto has_dilatation) {
      with_constant(options.may_break && breaking_.is_armed(), [&](auto may_break) { all_packs(body, corrections, has_dilatation, may_break); });
    });
  };
  if (family.list()) {
    const ListConstants constants{law_, family.list()->length.data(), stretch_.data(), dilatation_.data(), std::as_const(direction_).pointers()};
    over(ListedBonds(family), constants, NoCorrections{});  // the factors are in the constants
  } else {
    const StencilBonds bonds(family);
    const StencilConstants constants{constants_, projection_};
    with_bond_corrections(correction_, half_squares_, [&](const auto& corrections) { over(bonds, constants, corrections); });
  }
  if (options.may_break) flow(particles, family);
}

template void PlasticForce::pass<double>(Particles&, Family&, const PassOptions&, RowSums&);
#if defined(__AVX2__) && !defined(FCCDA_SCALAR_PACK)
template void PlasticForce::pass<NativePack>(Particles&, Family&, const PassOptions&, RowSums&);
#endif

void PlasticForce::flow(const Particles& particles, const Family& family) {
  parallel_for(static_cast<std::ptrdiff_t>(particles.rows()), [&](std::ptrdiff_t number) {
    const auto row = static_cast<std::size_t>(number);
    dissipation_[row] += pending_[row];
    pending_[row] = 0;
    const std::size_t begin = row * particles.row_slots(), end = std::min(begin + particles.row_slots(), particles.slots());
    for (std::size_t eight = begin / byte_lanes; eight < end / byte_lanes; ++eight)
      if (is_hot_[eight])
        for (std::size_t slot = eight * byte_lanes; slot < (eight + 1) * byte_lanes; ++slot)
          if (is_stress_known(slot) && particles.is_occupied(slot)) flow(slot, row, particles, family);
  });
  std::swap(pressure_, latest_pressure_);
}

void PlasticForce::flow(std::size_t slot, std::size_t row, const Particles& particles, const Family& family) {
  SymmetricTensor stress = tensor_at(stress_, slot);
  const SymmetricTensor before = stress;
  const double half_volume = 0.5 * particles.volume(slot), p = pressure_of(stress);
  dissipation_[row] += half_volume * double_contraction(before, tensor_at(increment_, slot));
  SymmetricTensor increment{};
  const bool is_crushed = has_failed_[slot] && second_invariant(stress) > plasticity_.residual * p * p;
  if (p > 0 && (is_crushed || plasticity_.ellipse.function(stress) > 0)) {
    increment =
        is_crushed ? return_to_residual(plasticity_.ellipse, plasticity_.residual, moduli_, stress) : return_to_surface(plasticity_.ellipse, moduli_, stress);
    SymmetricTensor sum = tensor_at(strain_, slot);
    for (std::size_t c = 0; c < 6; ++c) sum[c] += increment[c];
    set(strain_, slot, sum);
    double& equivalent = equivalent_.component(0)[slot];
    if (equivalent == 0) mark(slot, family);
    equivalent += perimpact::equivalent_strain(increment);
    pending_[row] += half_volume * double_contraction(before, increment);
    if (!has_failed_[slot] && breaking_.is_armed() && resistance_.component(0)[slot] < unbreakable &&
        equivalent > plasticity_.failure.at(p / largest_pressure_)) {
      has_failed_[slot] = 1;
      resistance_.component(0)[slot] = 0;
    }
  }
  set(increment_, slot, increment);
}

/// From the next pass on the particle and those that are bonded to it know its plastic strain.
void PlasticForce::mark(std::size_t slot, const Family& family) {
  pressure_slope_.component(0)[slot] = yields_before_it_breaks;
  const auto mark_at = [&](std::size_t at) { std::atomic_ref(is_plastic_[at / byte_lanes]).store(1, std::memory_order_relaxed); };
  mark_at(slot);
  family.for_each_bond(slot, [&](const FamilyBond& bond) { mark_at(bond.j); });
}

void PlasticForce::set_plastic_strain(std::size_t slot, const SymmetricTensor& strain, const Family& family) {
  set(strain_, slot, strain);
  equivalent_.component(0)[slot] = perimpact::equivalent_strain(strain);
  mark(slot, family);
}

double PlasticForce::dissipation() const {
  double sum = 0;
  for (const double of_row : dissipation_) sum += of_row;
  return sum;
}

double PlasticForce::bytes() const {
  const std::size_t numbers = 18 * strain_.slots() + 5 * equivalent_.slots() + theta_.slots() + stretch_.size() + dilatation_.size() + 3 * direction_.slots();
  return correction_.bytes() + breaking_.bytes() + static_cast<double>(sizeof(double) * numbers + has_failed_.size() + is_plastic_.size() + is_hot_.size());
}

}  // namespace perimpact
