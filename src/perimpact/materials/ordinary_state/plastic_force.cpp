#include "perimpact/materials/ordinary_state/plastic_force.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state_force.hpp"
#include "perimpact/materials/ordinary_state/plastic_kernels.hpp"

namespace perimpact {

using namespace fccda;
using namespace plastic;

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
      tolerated_(overshoot_tolerance * plasticity.ellipse.compressive_strength()),
      correction_(std::move(correction)),
      // s of the length (1 + s_c) |ξ|
      half_limit_(rule ? 0.5 * (rule->stretch + 0.5 * rule->stretch * rule->stretch) : unbreakable),
      strength_(strength) {
  if (rule) breaking_ = Breaking(*rule, {}, family, particles);
  const std::size_t slots = particles.slots(), slack = particles.slack();
  strain_ = increment_ = stress_ = TensorArray(slots, slack);
  equivalent_ = pressure_ = latest_pressure_ = ScalarArray(slots, slack);
  pressure_slope_ = ScalarArray(slots, slack, 3.0 / (16 * law.elastic().youngs_modulus));
  if (law_.needs_dilatation()) theta_ = ScalarArray(slots, slack);
  has_failed_.assign(slots, 0);
  resistance_ = ScalarArray(slots, slack, half_limit_);
  find_resistance(particles);
  if (!particles.share().is_whole()) is_known_ghost_.assign(slots, 0);
  is_plastic_.assign(slots / byte_lanes, 0);
  is_hot_.assign(slots / byte_lanes, 0);
  affected_.assign(slots / byte_lanes, 0);
  flows_.assign(slots / byte_lanes, 0);
  dissipation_.assign(particles.slots() / byte_lanes, 0);
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

void PlasticForce::find_resistance(const Particles& particles) {
  for (std::size_t slot = 0; slot < has_failed_.size(); ++slot) {
    const double intact = half_limit_ * (strength_.empty() ? 1 : strength_[slot]);
    resistance_.component(0)[slot] = has_failed_[slot] != 0 && intact != unbreakable ? 0 : intact;
  }
  particles.share().refresh({resistance_.component(0)});
}

template <class Pack>
void PlasticForce::pass(Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums) {
  pass_with(particles, family, options, [&](Packs which) { evaluate<Pack>(which, particles, family, options, sums); });
}

/// Bonds break, and lose their energy, where all packs are evaluated.
template <class Pack>
void PlasticForce::evaluate(Packs which, Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums) {
  const bool again = which == Packs::affected;
  // what has flowed lies in few rows
  const auto rows = [&](std::ptrdiff_t count, const auto& in_row) { parallel_for(count, again ? Schedule::uneven : Schedule::even, in_row); };
  const auto skips = [&](std::size_t slot) { return again && !options.with_energy && affected_[slot / byte_lanes] == 0; };
  const auto all_packs = [&](const auto& body, const auto& corrections, auto has_dilatation, auto may_break) {
    constexpr bool with_theta = decltype(has_dilatation)::value, breaks = decltype(may_break)::value;
    const auto breaking_in = [&]([[maybe_unused]] std::size_t eight, auto breaks_here) {
      if constexpr (decltype(breaks_here)::value)
        return Breaks{{&sums.broken_ends[eight]}};
      else
        return Holds{};
    };
    if constexpr (with_theta)
      for_each_pack<Pack>(
          particles,
          [&](std::size_t eight, std::size_t slot) {
            if (skips(slot)) return;
            const auto breaking = breaking_in(eight, std::bool_constant<breaks>());
            with_factors(body, slot, corrections, [&](const auto& view, std::size_t at, const auto& factors) {
              with_constant(is_plastic_[at / byte_lanes] != 0, [&](auto plastic) {
                dilatation_of_pack<Pack, decltype(plastic)::value>(view, at, breaking, factors, sums.fracture_energy[eight]);
              });
            });
          },
          rows);
    if constexpr (with_theta) particles.share().begin_refresh({theta_.component(0)});
    if (options.with_energy) std::fill(sums.energy.begin(), sums.energy.end(), 0.0);
    const std::array<double*, 6> stress = stress_.writable_pointers();
    const std::array<double*, 3> forces = particles.force_density.writable_pointers();
    const auto evaluate_pack = [&](std::size_t eight, std::size_t slot) {
      if (skips(slot)) return;
      double& fracture = sums.fracture_energy[eight];
      const auto breaking = breaking_in(eight, std::bool_constant < breaks && !with_theta > ());  // the pass before has broken what breaks
      std::uint8_t& hot = is_hot_[slot / byte_lanes];
      const std::size_t first = slot % byte_lanes;
      if (first == 0) hot = 0;
      const auto heat = [&] { hot = static_cast<std::uint8_t>(hot | (((1u << lanes<Pack>)-1u) << first)); };
      const OfPack<Pack> of = with_factors(body, slot, corrections, [&](const auto& view, std::size_t at, const auto& factors) {
        if (with_theta || is_plastic_[at / byte_lanes]) {
          heat();
          if (is_plastic_[at / byte_lanes]) return force_of_pack<Pack, true, with_theta, true>(view, at, breaking, factors, fracture, stress);
          return force_of_pack<Pack, false, with_theta, true>(view, at, breaking, factors, fracture, stress);
        }
        const OfPack<Pack> elastic = force_of_pack<Pack, false, with_theta, false>(view, at, breaking, factors, fracture, stress);
        if (bits_where_greater(elastic.energy, Pack(elastic_limit_)) != 0) {
          heat();
          force_of_pack<Pack, false, with_theta, true>(view, at, Holds{}, factors, fracture, stress);
        }
        return elastic;
      });
      if (again) {
        const Vec3<Pack> before{load<Pack>(forces[0] + slot), load<Pack>(forces[1] + slot), load<Pack>(forces[2] + slot)};
        dissipation_[eight] += lost_work(body.particles, slot, before, of.force, options.dt);
      }
      for (std::size_t c = 0; c < 3; ++c) store(forces[c] + slot, of.force[c]);
      if (options.may_break) store(latest_pressure_.component(0) + slot, of.pressure);
      if (options.with_energy) sums.energy[eight] += energy_of_pack(of.energy, particles, slot);
    };
    for_each_pack<Pack>(particles, evaluate_pack, rows);
  };
  const auto over = [&](const auto& body, const auto& corrections) {
    with_constant(law_.needs_dilatation(), [&](auto has_dilatation) {
      with_constant(!again && options.may_break && breaking_.is_armed(), [&](auto may_break) { all_packs(body, corrections, has_dilatation, may_break); });
    });
  };
  if (!family.list()) return with_view_of_lattice(particles, StencilBonds(family), family.offsets().size(), options.dt, over);
  const ListConstants constants{law_, family.list()->length.data(), stretch_.data(), dilatation_.data(), std::as_const(direction_).pointers()};
  over(BodyView<ListedBonds, ListConstants>{particles.view(), ListedBonds(family), constants, correction_.table_of().data(), law_.a(),
                                            std::as_const(strain_).pointers(), std::as_const(increment_).pointers(), pressure_.component(0),
                                            pressure_slope_.component(0), resistance_.component(0), theta_.component(0), options.dt},
       NoCorrections{});  // the factors are in the constants
}

template void PlasticForce::pass<double>(Particles&, Family&, const PassOptions&, SumsOfEights&);
#if defined(__AVX2__) && !defined(FCCDA_SCALAR_PACK)
template void PlasticForce::pass<NativePack>(Particles&, Family&, const PassOptions&, SumsOfEights&);
#endif

StepMessages PlasticForce::messages() const {
  StepMessages messages{.refreshed = {}, .collectives = reduction_of(2)};  // whether any particle flows
  if (law_.needs_dilatation()) {
    messages.refreshed.push_back(sizeof(double));       // θ
    messages.refreshed.push_back(15 * sizeof(double));  // refresh_ghosts(): the stress of all particles is evaluated
  }
  messages.refreshed.push_back(sizeof(double));  // pressure
  return messages;
}

double PlasticForce::bytes() const {
  const std::size_t numbers =
      18 * strain_.slots() + 5 * equivalent_.slots() + theta_.slots() + stretch_.size() + dilatation_.size() + 3 * direction_.slots() + strength_.size();
  return correction_.bytes() + breaking_.bytes() +
         static_cast<double>(sizeof(double) * numbers + sizeof(double) * (dissipation_.size() + pending_.size()) + has_failed_.size() + is_plastic_.size() +
                             is_hot_.size() + affected_.size() + flows_.size());
}

}  // namespace perimpact
