/// Kernels of the ordinary state-based material on packs of particles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "base/host_device.hpp"
#include "perimpact/force/bond_loop.hpp"
#include "perimpact/force/correction_kernels.hpp"
#include "perimpact/force/pass.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state_force.hpp"
#include "perimpact/particles/particles_view.hpp"

namespace perimpact::ordinary_state {

using namespace fccda;

/// Constants of the bonds of a stencil: those of complete families, and one set for each further table of factors.
struct StencilConstants {
  const OrdinaryState::Folded<double>* folded;  // table after table
  std::size_t bonds;

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    visit(folded);
  }
  FCCDA_HD StencilConstants of_table(std::int32_t table) const { return {folded + static_cast<std::size_t>(table) * bonds, bonds}; }

  template <class Pack>
  FCCDA_HD const OrdinaryState::Folded<double>& constants(std::size_t index) const {
    return folded[index];
  }
};

/// The same for the bonds of a list.
struct ListConstants {
  OrdinaryState law;
  const double *length, *stretch, *dilatation;

  FCCDA_HD ListConstants of_table(std::int32_t) const { return *this; }
  template <class Pack>
  FCCDA_HD OrdinaryState::Folded<Pack> constants(std::size_t index) const {
    return law.fold(load<Pack>(length + index), load<Pack>(stretch + index), load<Pack>(dilatation + index));
  }
};

/// Data that the passes over one body read and write.
template <class Bonds, class Constants>
struct BodyView {
  ParticlesView particles;
  Bonds bonds;
  Constants constants;
  const std::int32_t* table_of;  // of each eight (CorrectionFactors)
  double a;                      // [Pa] of the law
  std::array<double*, 3> force;  // [N/m³]
  double* theta;                 // [-]
  double dt;                     // [s], as in PassOptions

  /// All pointers but those of the bonds.
  template <class Visit>
  void visit_pointers(const Visit& visit) {
    particles.visit_pointers(visit);
    constants.visit_pointers(visit);
    visit(table_of);
    for (double*& component : force) visit(component);
    visit(theta);
  }
  FCCDA_HD BodyView with(const Constants& others) const { return {particles, bonds, others, table_of, a, force, theta, dt}; }
};

/// Relative velocity y_j' - y_i' [m/s] of the bonds of a pack.
template <class Pack, class View, class Bond>
FCCDA_HD Vec3<Pack> relative_velocity(const View& body, std::size_t slot, const Bond& bond) {
  const std::array<const double*, 3> v = body.particles.velocity;
  return {bond.neighbour.of(v[0]) - load<Pack>(v[0] + slot), bond.neighbour.of(v[1]) - load<Pack>(v[1] + slot),
          bond.neighbour.of(v[2]) - load<Pack>(v[2] + slot)};
}

/// Stretch energy of bonds that just broke, in the middle of the step, u - dt u'/2 [J], at this end, summed over the lanes in `bond.intact`.
template <class Pack, class View, class Bond, class Correction>
FCCDA_COLD FCCDA_HD double released_energy(const View& body, std::size_t slot, const Bond& bond, const Correction& correction) {
  const auto& folded = body.constants.template constants<Pack>(bond.index);
  const Pack inverse_length = inverse_square_root(bond.squared_length);
  const Pack pull = OrdinaryState::stretch_force(folded, inverse_length);  // the ends share the energy of a bond, and thus the power of its force
  const Pack rate = Pack(0.5) * pull * dot(bond.between, relative_velocity<Pack>(body, slot, bond));
  const Pack released = OrdinaryState::stretch_energy(folded, bond.squared_length * inverse_length) - Pack(0.5 * body.dt) * rate;
  const Pack density = correction.stretch.corrected(released, correction.stretch.template of<Pack>(slot), bond.index, bond.neighbour);
  return energy_of_pack(bond.where_intact(density), body.particles, slot);
}

/// Contribution of the bonds of a pack to the rate of θ [1/s].
template <class Pack, class View, class Bond>
FCCDA_HD Pack dilatation_rate(const View& body, std::size_t slot, const Bond& bond) {
  return Pack(body.constants.template constants<Pack>(bond.index).theta_slope) * inverse_square_root(bond.squared_length) *
         dot(bond.between, relative_velocity<Pack>(body, slot, bond));
}

/// Dilatation energy released by the particles of a pack: a θ² - dt (a θ²)'/2 before failure, less the same after it [J]. `gone` [-], `gone_rate` [1/s]:
/// contributions of the broken bonds to the sum θ and its rate; `sum`: that of the remaining bonds.
template <class Pack, class View, class Correction>
FCCDA_COLD FCCDA_HD double released_dilatation_energy(const View& body, std::size_t slot, Pack sum, Pack gone, Pack gone_rate, const Correction& correction) {
  const auto of_i = correction.dilatation.template of<Pack>(slot);
  Pack rate(0.0);
  for_each_bond<Pack>(body.bonds, body.particles.position, slot, Unbreakable{}, [&](const auto& bond) {
    const Pack slope = dilatation_rate<Pack>(body, slot, bond);
    rate += bond.where_intact(correction.dilatation.corrected(slope, of_i, bond.index, bond.neighbour));
  });
  const auto density = [&](Pack of_sum, Pack of_rate) {
    const Pack theta = correction.dilatation_of(correction.pushing(of_sum, slot), slot),
               change = correction.dilatation_of(correction.pushing(of_rate, slot), slot);
    return OrdinaryState::dilatation_energy(body.a, theta) - Pack(body.dt * body.a) * theta * change;
  };
  return energy_of_pack(density(sum + gone, rate + gone_rate) - density(sum, rate), body.particles, slot);
}

/// θ of the particles of one pack. Adds the released energy to `fracture` [J].
template <class Pack, class View, class Breaker, class Correction>
FCCDA_HD void dilatation_of_pack(const View& body, std::size_t slot, const Breaker& breaking, const Correction& correction, double& fracture) {
  const auto of_i = correction.dilatation.template of<Pack>(slot);
  const auto term_of = [&](const auto& bond) {
    const Pack term = OrdinaryState::dilatation(body.constants.template constants<Pack>(bond.index), length_of(bond.squared_length));
    return bond.where_intact(correction.dilatation.corrected(term, of_i, bond.index, bond.neighbour));
  };
  Pack theta(0.0);
  [[maybe_unused]] double released = 0;
  [[maybe_unused]] Pack gone(0.0), gone_rate(0.0);
  [[maybe_unused]] bool broke = false;
  for_each_bond<Pack>(
      body.bonds, body.particles.position, slot, breaking, [&](const auto& bond) { theta += term_of(bond); },
      [&](const auto& bond) {
        released += released_energy<Pack>(body, slot, bond, correction);
        gone += term_of(bond);
        gone_rate += bond.where_intact(correction.dilatation.corrected(dilatation_rate<Pack>(body, slot, bond), of_i, bond.index, bond.neighbour));
        broke = true;
      });
  if constexpr (Breaker::is_armed)
    if (broke) [[unlikely]]
      fracture += released + released_dilatation_energy(body, slot, theta, gone, gone_rate, correction);
  store(body.theta + slot, correction.pushing(theta, slot));
}

/// Force density of the particles of one pack; returns their total energy [J] if with_energy. Adds the released energy to `fracture` [J].
template <class Pack, bool has_dilatation, bool with_energy, class View, class Breaker, class Correction>
FCCDA_HD double force_of_pack(const View& body, std::size_t slot, const Breaker& breaking, const Correction& correction, double& fracture) {
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
    pull = bond.where_intact(pull);
    force.x = fused_multiply_add(pull, bond.between.x, force.x);
    force.y = fused_multiply_add(pull, bond.between.y, force.y);
    force.z = fused_multiply_add(pull, bond.between.z, force.z);
    if constexpr (with_energy) {
      const Pack stored = OrdinaryState::stretch_energy(folded, bond.squared_length * inverse_length);
      energy += bond.where_intact(correction.stretch.corrected(stored, stretch_of_i, bond.index, bond.neighbour));
    }
  };
  [[maybe_unused]] double released = 0;
  for_each_bond<Pack>(body.bonds, body.particles.position, slot, breaking, add,
                      [&](const auto& bond) { released += released_energy<Pack>(body, slot, bond, correction); });
  if constexpr (Breaker::is_armed)
    if (released != 0) [[unlikely]]
      fracture += released;
  store(body.force[0] + slot, force.x);
  store(body.force[1] + slot, force.y);
  store(body.force[2] + slot, force.z);
  if constexpr (with_energy && has_dilatation) energy += OrdinaryState::dilatation_energy(body.a, correction.dilatation_of(theta_i, slot));
  return with_energy ? energy_of_pack(energy, body.particles, slot) : 0.0;
}

}  // namespace perimpact::ordinary_state

namespace perimpact {

template <class Bonds, class F>
void OrdinaryStateForce::with_view_of_lattice(Particles& particles, const Bonds& bonds, std::size_t rows, double dt, const F& f) {
  const ordinary_state::BodyView<Bonds, ordinary_state::StencilConstants> body{
      particles.view(),    bonds, {folded_.data(), rows}, correction_.table_of().data(), law_.a(), particles.force_density.writable_pointers(),
      theta_.component(0), dt};
  if (correction_.kind() == CorrectionKind::family)
    f(body, corrections_by_family());
  else
    with_bond_corrections(correction_, half_squares_, [&](const auto& corrections) { f(body, corrections); });
}

}  // namespace perimpact
