/// Kernels of the correspondence material on packs of particles: response to F with the stabilisation of each particle, and forces.
#pragma once

#include <type_traits>

#include "perimpact/materials/correspondence/body_view.hpp"

namespace perimpact::correspondence {

using namespace fccda;

/// Residual of the bonds of a pack: Σ ω |z|² v V [m⁵].
template <std::size_t D, class Pack, class View>
FCCDA_HD Pack remainder_of_pack(const View& body, std::size_t slot, const SmallMatrix<Pack, D>& gradient) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  Pack sum(0.0);
  for_each_bond<Pack>(body.bonds, body.particles.position, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    Pack squares(0.0);
    for (std::size_t r = 0; r < D; ++r) {
      Pack z = bond.between[r];
      for (std::size_t s = 0; s < D; ++s) z = z - gradient.m[r][s] * xi[s];
      squares = fused_multiply_add(z, z, squares);
    }
    sum = fused_multiply_add(bond.where_intact(body.shapes.template weight<Pack>(bond.index)), squares, sum);
  });
  return sum;
}

/// Energy W - dt W'/2 [J] of the particles of a pack in the middle of the last step, from these bonds and the cached K⁻¹ and χ.
template <std::size_t D, class Pack, class View>
FCCDA_COLD FCCDA_HD double energy_amid_step(const View& body, std::size_t slot) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  const SmallMatrix<Pack, D> moment = moment_of_pack<D, Pack>(body, slot, body.particles.position);
  const auto response = body.law.respond(moment, inverse_shape_of<D, Pack>(body, slot), remaining_of<Pack>(body.shape, slot));
  const std::array<const double*, 3> v = body.particles.velocity;
  Pack power(0.0);  // Σ t·(v_j - v_i) [W/m³]
  for_each_bond<Pack>(body.bonds, body.particles.position, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    Pack sum(0.0);
    for (std::size_t r = 0; r < 3; ++r) {
      Pack pull = response.along * bond.between[r];
      if (r < D)
        for (std::size_t s = 0; s < D; ++s) pull = fused_multiply_add(response.through.m[r][s], xi[s], pull);
      sum = fused_multiply_add(pull, bond.neighbour.of(v[r]) - load<Pack>(v[r] + slot), sum);
    }
    power = fused_multiply_add(bond.where_intact(body.shapes.template weight<Pack>(bond.index)), sum, power);
  });
  const Pack energy = fused_multiply_add(Pack(0.5) * response.along, remainder_of_pack<D, Pack>(body, slot, response.gradient), response.energy);
  return energy_of_pack(fused_multiply_add(Pack(-0.5 * body.dt), power, energy), body.particles, slot);
}

/// Computes B and c of the particles of one pack; returns their energy density [J/m³] if with_energy. Adds the released energy to `fracture` [J].
template <std::size_t D, class Pack, class View, class Breaking>
FCCDA_HD Pack response_of_pack(const View& body, std::size_t slot, const Breaking& breaking, bool with_energy, double& fracture) {
  if constexpr (Breaking::is_armed) follow_bonds<D, Pack>(body, slot);  // as after a restart: failure in this pass is counted from the current bonds
  [[maybe_unused]] bool broke = false;
  const SmallMatrix<Pack, D> moment = moment_of_pack<D, Pack>(body, slot, body.particles.position, breaking, broke);
  [[maybe_unused]] double released = 0;
  if (broke) [[unlikely]]
    released = energy_amid_step<D, Pack>(body.before(), slot);
  follow_bonds<D, Pack>(body, slot);
  if (broke) [[unlikely]]
    fracture += released - energy_amid_step<D, Pack>(body, slot);
  const auto response = body.law.respond(moment, inverse_shape_of<D, Pack>(body, slot), remaining_of<Pack>(body.shape, slot));
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) store(body.response[r * D + s] + slot, response.through.m[r][s]);
  store(body.response[D * D] + slot, response.along);
  if (!with_energy) return Pack(0.0);
  return fused_multiply_add(Pack(0.5) * response.along, remainder_of_pack<D, Pack>(body, slot, response.gradient), response.energy);
}

/// Force density of the particles of one pack.
template <std::size_t D, class Pack, class View>
FCCDA_HD void force_of_pack(const View& body, std::size_t slot) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  Pack own[D * D + 1], force[3]{};
  for (std::size_t n = 0; n <= D * D; ++n) own[n] = load<Pack>(body.response[n] + slot);
  for_each_bond<Pack>(body.bonds, body.particles.position, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    const Pack weight = bond.where_intact(body.shapes.template weight<Pack>(bond.index));
    const Pack along = own[D * D] + bond.neighbour.of(body.response[D * D]);
    for (std::size_t r = 0; r < D; ++r) {
      Pack pull = along * bond.between[r];
      for (std::size_t s = 0; s < D; ++s) pull = fused_multiply_add(own[r * D + s] + bond.neighbour.of(body.response[r * D + s]), xi[s], pull);
      force[r] = fused_multiply_add(weight, pull, force[r]);
    }
  });
  for (std::size_t c = 0; c < 3; ++c) store(body.force[c] + slot, force[c]);
}

}  // namespace perimpact::correspondence
