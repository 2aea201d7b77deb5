/// Kernels of the stabilisation bond-level on packs of particles.
#pragma once

#include "perimpact/materials/correspondence/body_view.hpp"

namespace perimpact::correspondence {

using namespace fccda;

/// Topological distance of eight slots from the bonds that broke in a pass.
enum Nearness : std::uint8_t {
  far_off,
  beside_changed,  ///< has a neighbour whose energy changed
  changed,         ///< a neighbour lost bonds, which changed its own energy
  broke_here
};

template <std::size_t D, class Pack>
FCCDA_HD SmallMatrix<Pack, D> load_matrix(const std::array<double*, D * D>& from, std::size_t slot) {
  SmallMatrix<Pack, D> matrix;
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) matrix.m[r][s] = load<Pack>(from[r * D + s] + slot);
  return matrix;
}

template <std::size_t D, class Pack>
FCCDA_HD void store_matrix(const std::array<double*, D * D>& to, std::size_t slot, const SmallMatrix<Pack, D>& matrix) {
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) store(to[r * D + s] + slot, matrix.m[r][s]);
}

/// (own - neighbour's) ξ for one bond of each particle of a pack.
template <std::size_t D, class Pack, class Bond>
FCCDA_HD Vec3<Pack> difference_along(const SmallMatrix<Pack, D>& own, const std::array<double*, D * D>& all, const Bond& bond, const Vec3<Pack>& xi) {
  Vec3<Pack> difference{Pack(0.0), Pack(0.0), Pack(0.0)};
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) difference[r] = fused_multiply_add(own.m[r][s] - bond.neighbour.of(all[r * D + s]), xi[s], difference[r]);
  return difference;
}

/// Stores F of the particles of one pack, from their moment Σ ω y⊗ξ v V.
template <std::size_t D, class Pack, class View>
FCCDA_HD void store_gradient(const View& body, std::size_t slot, const SmallMatrix<Pack, D>& moment) {
  store_matrix<D>(body.gradient, slot, Correspondence::gradient(moment, inverse_shape_of<D, Pack>(body, slot), remaining_of<Pack>(body.shape, slot)));
}

/// Recomputes the stored F, or dF/dt, of the particles of one pack.
template <std::size_t D, class Pack, class View>
FCCDA_HD void renew_gradient(const View& body, std::size_t slot) {
  store_gradient<D, Pack>(body, slot, moment_of_pack<D, Pack>(body, slot, body.particles.position));
}
template <std::size_t D, class Pack, class View>
FCCDA_HD void renew_rate(const View& body, std::size_t slot) {
  store_matrix<D>(body.rate, slot, moment_of_pack<D, Pack>(body, slot, body.particles.velocity) * inverse_shape_of<D, Pack>(body, slot));
}

/// Energy density W - dt W'/2 [J/m³] of the particles of one pack, from the stored gradients (and their rates).
template <std::size_t D, class Pack, bool with_rate, class View>
FCCDA_NOINLINE FCCDA_HD Pack bond_level_energy(const View& body, std::size_t slot) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  const SmallMatrix<Pack, D> gradient = load_matrix<D, Pack>(body.gradient, slot);
  [[maybe_unused]] SmallMatrix<Pack, D> rate, turning_rate;
  if constexpr (with_rate) rate = load_matrix<D, Pack>(body.rate, slot);
  SmallMatrix<Pack, D> turning;  // T
  Pack residual(0.0), difference(0.0);
  [[maybe_unused]] Pack residual_rate(0.0), difference_rate(0.0);
  [[maybe_unused]] const std::array<const double*, 3> v = body.particles.velocity;
  for_each_bond<Pack>(body.bonds, body.particles.position, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    const Pack weight = bond.where_intact(body.shapes.template weight<Pack>(bond.index));
    const Pack shared = weight * bond.neighbour.of(body.shape[body.shape.size() - 2]);
    const Vec3<Pack> d = difference_along<D>(gradient, body.gradient, bond, xi);
    add_outer(turning, d, xi, shared);
    [[maybe_unused]] Vec3<Pack> d_rate;
    if constexpr (with_rate) {
      d_rate = difference_along<D>(rate, body.rate, bond, xi);
      add_outer(turning_rate, d_rate, xi, shared);
    }
    for (std::size_t r = 0; r < D; ++r) {
      Pack z = bond.between[r];
      for (std::size_t s = 0; s < D; ++s) z = z - gradient.m[r][s] * xi[s];
      residual = fused_multiply_add(weight * z, z, residual);
      difference = fused_multiply_add(shared * d[r], d[r], difference);
      if constexpr (with_rate) {
        Pack z_rate = bond.neighbour.of(v[r]) - load<Pack>(v[r] + slot);
        for (std::size_t s = 0; s < D; ++s) z_rate = z_rate - rate.m[r][s] * xi[s];
        residual_rate = fused_multiply_add(weight * z, z_rate, residual_rate);
        difference_rate = fused_multiply_add(shared * d[r], d_rate[r], difference_rate);
      }
    }
  });
  const SmallMatrix<Pack, D> half_inverse = scaled_plus(Pack(0.5), inverse_shape_of<D, Pack>(body, slot), Pack(0.0));
  const auto stress = body.law.stress(scaled_sum(Pack(1.0), turning * half_inverse, gradient));
  const Pack remaining = remaining_of<Pack>(body.shape, slot), c = remaining * body.law.stabilisation(Pack(0.0));
  Pack energy = remaining * stress.energy + Pack(0.5) * c * (residual - Pack(0.25) * difference);
  if constexpr (with_rate) {
    const Pack power =
        remaining * contraction(stress.first, scaled_sum(Pack(1.0), turning_rate * half_inverse, rate)) + c * (residual_rate - Pack(0.25) * difference_rate);
    energy = fused_multiply_add(Pack(-0.5 * body.dt), power, energy);
  }
  return energy;
}

/// F¹ of the particles of one pack, its stress Q = χ P K⁻¹, and the part of B without the stresses of neighbours.
template <std::size_t D, class Pack, class View>
FCCDA_HD void bond_level_stress(const View& body, std::size_t slot) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  const SmallMatrix<Pack, D> gradient = load_matrix<D, Pack>(body.gradient, slot), inverse = inverse_shape_of<D, Pack>(body, slot);
  SmallMatrix<Pack, D> turning;  // T
  for_each_bond<Pack>(body.bonds, body.particles.position, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    const Pack weight = bond.where_intact(body.shapes.template weight<Pack>(bond.index));
    add_outer(turning, difference_along<D>(gradient, body.gradient, bond, xi), xi, weight * bond.neighbour.of(body.shape[body.shape.size() - 2]));
  });
  const SmallMatrix<Pack, D> turned = turning * inverse;  // T K⁻¹
  const auto stress = body.law.stress(scaled_sum(Pack(0.5), turned, gradient));
  const Pack remaining = remaining_of<Pack>(body.shape, slot), c = remaining * body.law.stabilisation(Pack(0.0));
  const SmallMatrix<Pack, D> carried = stress.first * scaled_plus(remaining, inverse, Pack(0.0));
  store_matrix<D>(body.carried, slot, carried);
  const SmallMatrix<Pack, D> through = scaled_sum(Pack(-0.5) * c, turned, scaled_sum(Pack(-1.0) * c, gradient, carried));
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) store(body.response[r * D + s] + slot, through.m[r][s]);
  store(body.response[D * D] + slot, c);
}

/// Remaining part of B: stresses of the particle and its neighbours, whose F¹ depend on its F.
template <std::size_t D, class Pack, class View>
FCCDA_HD void bond_level_return(const View& body, std::size_t slot) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  const SmallMatrix<Pack, D> carried = load_matrix<D, Pack>(body.carried, slot);
  const Pack remaining = remaining_of<Pack>(body.shape, slot);
  SmallMatrix<Pack, D> sum;
  for_each_bond<Pack>(body.bonds, body.particles.position, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    const Pack of_j = bond.neighbour.of(body.shape[body.shape.size() - 2]);
    Vec3<Pack> d{Pack(0.0), Pack(0.0), Pack(0.0)};
    for (std::size_t r = 0; r < D; ++r)
      for (std::size_t s = 0; s < D; ++s)
        d[r] = fused_multiply_add(fused_multiply_add(of_j, carried.m[r][s], Pack(-1.0) * remaining * bond.neighbour.of(body.carried[r * D + s])), xi[s], d[r]);
    add_outer(sum, d, xi, bond.where_intact(body.shapes.template weight<Pack>(bond.index)));
  });
  const SmallMatrix<Pack, D> returned = sum * inverse_shape_of<D, Pack>(body, slot);
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s)
      store(body.response[r * D + s] + slot, fused_multiply_add(Pack(0.5), returned.m[r][s], load<Pack>(body.response[r * D + s] + slot)));
}

/// Computes F of the particles of one pack, with bond failure. Packs that lost bonds are completed by account_for_broken().
template <std::size_t D, class Pack, class View, class Breaking>
FCCDA_HD void gradient_of_pack(const View& body, std::size_t slot, const Breaking& breaking) {
  if constexpr (Breaking::is_armed) follow_bonds<D, Pack>(body, slot);
  [[maybe_unused]] bool broke = false;
  const SmallMatrix<Pack, D> moment = moment_of_pack<D, Pack>(body, slot, body.particles.position, breaking, broke);
  if (broke) [[unlikely]] {
    body.broken[slot / byte_lanes] = broke_here;
    return;
  }
  if constexpr (!Breaking::is_armed) follow_bonds<D, Pack>(body, slot);
  store_gradient<D, Pack>(body, slot, moment);
}

}  // namespace perimpact::correspondence
