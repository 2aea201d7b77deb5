/// Kernels of the ordinary state-based material with plastic strain on packs of particles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "perimpact/damage/strength.hpp"
#include "perimpact/force/bond_loop.hpp"
#include "perimpact/force/correction_kernels.hpp"
#include "perimpact/materials/ordinary_state/plastic_force.hpp"

namespace perimpact::plastic {

using namespace fccda;

template <class Pack>
using PackTensor = std::array<Pack, 6>;

/// ½ n·A·n of a tensor A, as factors of its components.
template <class Number>
FCCDA_HD std::array<Number, 6> projection_of(const Vec3<Number>& n) {
  const Number half(0.5);
  return {half * n.x * n.x, half * n.y * n.y, half * n.z * n.z, n.x * n.y, n.y * n.z, n.x * n.z};
}

/// The constants of the bonds of a stencil: those of whole families, and of any other table of factors.
struct StencilConstants {
  const PlasticForce::Constants<double>* all;  // table after table
  const SymmetricTensor* projections;
  std::size_t bonds;

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    visit(all), visit(projections);
  }
  FCCDA_HD StencilConstants of_table(std::int32_t table) const { return {all + static_cast<std::size_t>(table) * bonds, projections, bonds}; }

  template <class Pack>
  FCCDA_HD const PlasticForce::Constants<double>& constants(std::size_t index) const {
    return all[index];
  }
  template <class Pack>
  FCCDA_HD const SymmetricTensor& projection(std::size_t index) const {
    return projections[index];
  }
};

/// Those of the bonds of a list.
struct ListConstants {
  OrdinaryState law;
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
  ParticlesView particles;
  Bonds bonds;
  BondConstants constants;
  const std::int32_t* table_of;  // of each eight (CorrectionFactors)
  double a;                      // [Pa] of the law
  std::array<const double*, 6> strain, increment;
  const double *pressure, *pressure_slope, *resistance;
  double* theta;
  double dt;  // [s], as in PassOptions

  /// All pointers but those of the bonds.
  template <class Visit>
  void visit_pointers(const Visit& visit) {
    particles.visit_pointers(visit);
    constants.visit_pointers(visit);
    visit(table_of);
    for (auto* tensor : {&strain, &increment})
      for (const double*& component : *tensor) visit(component);
    visit(pressure), visit(pressure_slope), visit(resistance), visit(theta);
  }
  FCCDA_HD BodyView with(const BondConstants& others) const {
    return {particles, bonds, others, table_of, a, strain, increment, pressure, pressure_slope, resistance, theta, dt};
  }
};

/// Bond strains of a pack of particles; `is_plastic`: where one of their bonds has a plastic strain.
template <class Pack, bool is_plastic, class View>
class Strains {
 public:
  FCCDA_HD Strains(const View& body, std::size_t slot) : body_(body), constants_(body.constants) {
    if constexpr (is_plastic)
      for (std::size_t c = 0; c < 6; ++c) own_[c] = load<Pack>(body.strain[c] + slot);
  }

  /// s_e; bitwise equal at both ends, and with and without `is_plastic` where no strain is plastic.
  template <class Neighbour>
  FCCDA_HD Pack of(std::size_t index, Pack squared_length, const Neighbour& neighbour) const {
    const Pack total = fused_multiply_add(squared_length, Pack(constants_.template constants<Pack>(index).half_inverse), Pack(-0.5));
    if constexpr (!is_plastic) return total;
    return total - projected(constants_.template projection<Pack>(index), own_, body_.strain, neighbour);
  }

  /// ½ n·(A_i + A_j)·n
  template <class Projection, class Neighbour>
  FCCDA_HD static Pack projected(const Projection& projection, const PackTensor<Pack>& own, const std::array<const double*, 6>& of_all,
                                 const Neighbour& neighbour) {
    Pack sum = Pack(projection[0]) * (own[0] + neighbour.of(of_all[0]));
    for (std::size_t c = 1; c < 6; ++c) sum = fused_multiply_add(Pack(projection[c]), own[c] + neighbour.of(of_all[c]), sum);
    return sum;
  }

 private:
  const View& body_;
  InRegisters<Pack, decltype(View::constants)> constants_;
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

  FCCDA_HD BreakUnderPressure(const View& view, const Strains<Pack, is_plastic, View>& its_strains, std::size_t slot, const BeyondLimit& what)
      : body(view),
        strains(its_strains),
        resistance(load<Pack>(view.resistance + slot)),
        pressure(load<Pack>(view.pressure + slot)),
        slope(load<Pack>(view.pressure_slope + slot)),
        beyond(what) {}
  template <class P>
  FCCDA_HD P of(std::size_t) const {
    return P(0.0);
  }
  template <class Neighbour>
  FCCDA_HD unsigned bits(std::size_t index, Pack squared_length, Pack, const Neighbour& j) const {
    const Pack strain = strains.of(index, squared_length, j);
    if (bits_where_greater(strain, resistance) == 0) [[likely]]  // the neighbour and pressure only raise the limit; most bonds need neither
      return 0;
    const Pack squeezed = larger(pressure + j.of(body.pressure), Pack(0.0));
    const Pack limit = fused_multiply_add(slope + j.of(body.pressure_slope), squeezed, resistance + j.of(body.resistance));
    return bits_where_greater(strain, limit);
  }
};

/// s_e of the bonds of a pack at the step before.
template <class Pack, class View, class Bond>
FCCDA_HD Pack strain_before(const View& body, std::size_t slot, const Bond& bond, Pack strain) {
  if (body.dt == 0) return strain;
  const std::array<const double*, 3> v = body.particles.velocity;
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
FCCDA_COLD FCCDA_HD double released_energy(const View& body, std::size_t slot, const Bond& bond, Pack strain, const Correction& correction) {
  const auto& constants = body.constants.template constants<Pack>(bond.index);
  const Pack held = Pack(0.25) * Pack(constants.spring) * Pack(constants.squared) * strain * strain_before<Pack>(body, slot, bond, strain);
  const Pack density = correction.stretch.corrected(held, correction.stretch.template of<Pack>(slot), bond.index, bond.neighbour);
  return energy_of_pack(bond.where_intact(density), body.particles, slot);
}

/// Whether bonds break in a pass: not.
struct Holds {
  static constexpr bool may_break = false;
  template <class Pack, bool is_plastic, class View>
  FCCDA_HD Unbreakable breaker(const View&, const Strains<Pack, is_plastic, View>&, std::size_t) const {
    return {};
  }
};

/// Bonds beyond their limit break.
struct Breaks {
  static constexpr bool may_break = true;
  BeyondLimit beyond;
  template <class Pack, bool is_plastic, class View>
  FCCDA_HD BreakUnderPressure<Pack, is_plastic, View> breaker(const View& body, const Strains<Pack, is_plastic, View>& strains, std::size_t slot) const {
    return {body, strains, slot, beyond};
  }
};

/// Calls for_each_bond with the breaker of the pack.
template <class Pack, bool is_plastic, class View, class Breaking, class PerBond, class PerBroken>
FCCDA_HD void over_bonds(const View& body, const Strains<Pack, is_plastic, View>& strains, std::size_t slot, const Breaking& breaking, const PerBond& per_bond,
                         const PerBroken& per_broken) {
  for_each_bond<Pack>(body.bonds, body.particles.position, slot, breaking.template breaker<Pack, is_plastic>(body, strains, slot), per_bond, per_broken);
}

/// Elastic dilatation of the particles of one pack. Adds to `fracture` [J].
template <class Pack, bool is_plastic, class View, class Breaking, class Correction>
FCCDA_HD void dilatation_of_pack(const View& body, std::size_t slot, const Breaking& breaking, const Correction& correction, double& fracture) {
  const Strains<Pack, is_plastic, View> strains(body, slot);
  const auto of_i = correction.dilatation.template of<Pack>(slot);
  const auto term_of = [&](const auto& bond, Pack strain) {
    const Pack term = Pack(body.constants.template constants<Pack>(bond.index).dilatation) * strain;
    return bond.where_intact(correction.dilatation.corrected(term, of_i, bond.index, bond.neighbour));
  };
  const auto strain_of = [&](const auto& bond) { return strains.of(bond.index, bond.squared_length, bond.neighbour); };
  Pack theta(0.0);
  [[maybe_unused]] double released = 0;
  [[maybe_unused]] Pack gone(0.0), gone_before(0.0);
  [[maybe_unused]] bool broke = false;
  over_bonds<Pack, is_plastic>(
      body, strains, slot, breaking, [&](const auto& bond) { theta += term_of(bond, strain_of(bond)); },
      [&](const auto& bond) {
        const Pack strain = strain_of(bond);
        released += released_energy<Pack>(body, slot, bond, strain, correction);
        gone += term_of(bond, strain);
        gone_before += term_of(bond, strain_before<Pack>(body, slot, bond, strain));
        broke = true;
      });
  if constexpr (Breaking::may_break)
    if (broke) [[unlikely]] {
      Pack before(0.0);
      for_each_bond<Pack>(body.bonds, body.particles.position, slot, Unbreakable{},
                          [&](const auto& bond) { before += term_of(bond, strain_before<Pack>(body, slot, bond, strain_of(bond))); });
      const Pack density = Pack(body.a) * ((theta + gone) * (before + gone_before) - theta * before);
      fracture += released + energy_of_pack(density, body.particles, slot);
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
template <class Pack, bool is_plastic, bool has_dilatation, bool with_stress, class View, class Breaking, class Correction>
FCCDA_HD OfPack<Pack> force_of_pack(const View& body, std::size_t slot, const Breaking& breaking, const Correction& correction, double& fracture,
                                    const std::array<double*, 6>& stress) {
  const Strains<Pack, is_plastic, View> strains(body, slot);
  const auto stretch_of_i = correction.stretch.template of<Pack>(slot);
  [[maybe_unused]] const auto dilatation_of_i = correction.dilatation.template of<Pack>(slot);
  [[maybe_unused]] const Pack theta_i = has_dilatation ? load<Pack>(body.theta + slot) : Pack(0.0);
  Vec3<Pack> force{Pack(0.0), Pack(0.0), Pack(0.0)};
  Pack work(0.0), virial(0.0);
  [[maybe_unused]] PackTensor<Pack> sums{};
  InRegisters<Pack, decltype(View::constants)> constants_of = body.constants;
  const auto add = [&](const auto& bond) {
    const auto& constants = constants_of.template constants<Pack>(bond.index);
    const Pack strain = strains.of(bond.index, bond.squared_length, bond.neighbour);
    Pack pull = correction.stretch.corrected(Pack(constants.spring) * strain, stretch_of_i, bond.index, bond.neighbour);
    pull = bond.where_intact(pull);
    const Pack squared(constants.squared);
    work = fused_multiply_add(pull * squared, strain, work);
    if constexpr (has_dilatation) {
      const Pack push = Pack(constants.push) * (theta_i + bond.neighbour.of(body.theta));
      pull += bond.where_intact(correction.dilatation.corrected(push, dilatation_of_i, bond.index, bond.neighbour));
    }
    force.x = fused_multiply_add(pull, bond.between.x, force.x);
    force.y = fused_multiply_add(pull, bond.between.y, force.y);
    force.z = fused_multiply_add(pull, bond.between.z, force.z);
    if constexpr (with_stress) {
      const auto& projection = constants_of.template projection<Pack>(bond.index);
      const Pack power = pull * squared;
      for (std::size_t c = 0; c < 6; ++c) sums[c] = fused_multiply_add(power, Pack(projection[c]), sums[c]);
    }
    virial = fused_multiply_add(pull, squared, virial);
  };
  [[maybe_unused]] double released = 0;
  over_bonds<Pack, is_plastic>(body, strains, slot, breaking, add, [&](const auto& bond) {
    released += released_energy<Pack>(body, slot, bond, strains.of(bond.index, bond.squared_length, bond.neighbour), correction);
  });
  if constexpr (Breaking::may_break)
    if (released != 0) [[unlikely]]
      fracture += released;
  if constexpr (with_stress)
    for (std::size_t c = 0; c < 6; ++c) store(stress[c] + slot, c < 3 ? sums[c] : Pack(0.5) * sums[c]);
  Pack energy = Pack(0.25) * work;
  if constexpr (has_dilatation) energy += OrdinaryState::dilatation_energy(body.a, theta_i);
  return {force, energy, Pack(-1.0 / 6) * virial};
}

/// [J] ½ (F - F′)·Δx V of a pack: what the forces of the step do less when F, `before`, becomes F′, `now`.
template <class Pack>
FCCDA_HD double lost_work(const ParticlesView& particles, std::size_t slot, const Vec3<Pack>& before, const Vec3<Pack>& now, double dt) {
  Pack work(0.0);
  for (std::size_t c = 0; c < 3; ++c) work = fused_multiply_add(before[c] - now[c], load<Pack>(particles.velocity[c] + slot), work);
  return energy_of_pack(Pack(0.5 * dt) * work, particles, slot);
}

}  // namespace perimpact::plastic

namespace perimpact {

template <class Bonds, class F>
void PlasticForce::with_view_of_lattice(const Particles& particles, const Bonds& bonds, std::size_t rows, double dt, const F& f) {
  const plastic::BodyView<Bonds, plastic::StencilConstants> body{particles.view(),
                                                                 bonds,
                                                                 {constants_.data(), projection_.data(), rows},
                                                                 correction_.table_of().data(),
                                                                 law_.a(),
                                                                 std::as_const(strain_).pointers(),
                                                                 std::as_const(increment_).pointers(),
                                                                 pressure_.component(0),
                                                                 pressure_slope_.component(0),
                                                                 resistance_.component(0),
                                                                 theta_.component(0),
                                                                 dt};
  with_bond_corrections(correction_, half_squares_, [&](const auto& corrections) { f(body, corrections); });
}

template <class Evaluate>
void PlasticForce::pass_with(const Particles& particles, const Family& family, const PassOptions& options, const Evaluate& evaluate) {
  evaluate(Packs::all);
  if (!options.may_break) return;
  for (int returns = 1; flow(particles, family) && options.dt > 0 && returns < max_returns; ++returns) {
    mark_affected(particles, family);
    evaluate(Packs::affected);
  }
  std::swap(pressure_, latest_pressure_);
  particles.share().refresh({pressure_.component(0)});
}

}  // namespace perimpact
