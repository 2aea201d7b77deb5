/// Data that the kernels of the correspondence material read and write, and the shape tensors of packs of particles.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "perimpact/force/bond_loop.hpp"
#include "perimpact/materials/correspondence/correspondence_force.hpp"

namespace perimpact::correspondence {

using namespace fccda;

/// Reference vectors ξ and weights ω v V of the bonds of a stencil.
struct StencilShapes {
  std::span<const Vec3d> bonds;
  std::span<const double> weighted_volume;

  template <class Pack>
  struct OfParticle {};
  template <class Pack>
  OfParticle<Pack> of_particle(std::size_t) const {
    return {};
  }
  template <class Pack, class Bond>
  Vec3<Pack> reference(const Bond& bond, const OfParticle<Pack>&) const {
    const Vec3d& xi = bonds[bond.index];
    return {Pack(xi.x), Pack(xi.y), Pack(xi.z)};
  }
  template <class Pack>
  Pack weight(std::size_t index) const {
    return Pack(weighted_volume[index]);
  }
};

/// The same for the bonds of a list.
struct ListShapes {
  std::array<const double*, 3> X;
  const double* weighted_volume;

  template <class Pack>
  using OfParticle = Vec3<Pack>;
  template <class Pack>
  OfParticle<Pack> of_particle(std::size_t slot) const {
    return {load<Pack>(X[0] + slot), load<Pack>(X[1] + slot), load<Pack>(X[2] + slot)};
  }
  template <class Pack, class Bond>
  Vec3<Pack> reference(const Bond& bond, const OfParticle<Pack>& of_i) const {
    return {bond.neighbour.of(X[0]) - of_i.x, bond.neighbour.of(X[1]) - of_i.y, bond.neighbour.of(X[2]) - of_i.z};
  }
  template <class Pack>
  Pack weight(std::size_t index) const {
    return load<Pack>(weighted_volume + index);
  }
};

/// Data that the passes over one body read and write.
template <std::size_t D, class Bonds, class Shapes>
struct BodyView {
  const Particles& particles;
  std::array<const double*, 3> x;
  Bonds bonds;
  Shapes shapes;
  const Correspondence& law;
  std::array<double*, D*(D + 1) / 2 + 2> shape;
  const double* bound_at_first;
  std::array<double*, D * D + 1> response;
  std::array<double*, D * D> gradient, carried, rate;  // for the stabilisation bond-level
  const Family* family;
};

/// Adds ω v V a⊗b for one bond of each particle of a pack.
template <std::size_t D, class Pack>
void add_outer(SmallMatrix<Pack, D>& sum, const Vec3<Pack>& a, const Vec3<Pack>& b, Pack weight) {
  for (std::size_t s = 0; s < D; ++s) {
    const Pack weighted = weight * b[s];
    for (std::size_t r = 0; r < D; ++r) sum.m[r][s] = fused_multiply_add(a[r], weighted, sum.m[r][s]);
  }
}

template <std::size_t D, class Pack, class View>
SmallMatrix<Pack, D> inverse_shape_of(const View& body, std::size_t slot) {
  SmallMatrix<Pack, D> inverse;
  std::size_t n = 0;
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = r; s < D; ++s) inverse.m[r][s] = inverse.m[s][r] = load<Pack>(body.shape[n++] + slot);
  return inverse;
}

/// Moment Σ ω a⊗ξ v V of the particles of one pack, with a the differences of velocities or positions to their neighbours: for dF/dt or F. Bonds that
/// `breaking` breaks are left out, and set `broke`.
template <std::size_t D, class Pack, class View, class Breaking>
SmallMatrix<Pack, D> moment_of_pack(const View& body, std::size_t slot, const std::array<const double*, 3>& of, const Breaking& breaking,
                                    [[maybe_unused]] bool& broke) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  SmallMatrix<Pack, D> moment;
  for_each_bond<Pack>(
      body.bonds, of, slot, breaking,
      [&](const auto& bond) {
        add_outer(moment, bond.between, body.shapes.template reference<Pack>(bond, of_i), bond.where_intact(body.shapes.template weight<Pack>(bond.index)));
      },
      [&](const auto&) { broke = true; });
  return moment;
}
template <std::size_t D, class Pack, class View>
SmallMatrix<Pack, D> moment_of_pack(const View& body, std::size_t slot, const std::array<const double*, 3>& of) {
  bool none = false;
  return moment_of_pack<D, Pack>(body, slot, of, Unbreakable{}, none);
}

/// Computes K⁻¹ and χ of the particles of one pack from their intact bonds.
template <std::size_t D, class Pack, class View>
void make_shape(const View& body, std::size_t slot) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  SmallMatrix<Pack, D> shape;
  for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    add_outer(shape, xi, xi, bond.where_intact(body.shapes.template weight<Pack>(bond.index)));
  });
  const SmallMatrix<Pack, D> inverse = Correspondence::inverse_shape(shape);
  std::size_t n = 0;
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = r; s < D; ++s) store(body.shape[n++] + slot, inverse.m[r][s]);
  for (std::size_t i = slot; i < slot + lanes<Pack>; ++i) {
    const double bound = body.law.spring_bound(inverse_shape_of<D, double>(body, i));
    body.shape[n][i] = Correspondence::remaining(body.bound_at_first[i], bound);
    body.shape[n + 1][i] = body.shape[n][i] * bound;
  }
}

/// Recomputes K⁻¹ and χ of the particles of one pack if their bonds have changed.
template <std::size_t D, class Pack, class View>
void follow_bonds(const View& body, std::size_t slot, std::uint8_t* known) {
  const std::size_t eight = slot / byte_lanes, rows = body.bonds.rows(eight);
  const std::uint8_t* now = body.bonds.bytes(eight);
  if (std::equal(known, known + rows, now)) return;
  const unsigned own = ((1u << lanes<Pack>)-1u) << (slot % byte_lanes);
  for (std::size_t row = 0; row < rows; ++row) known[row] = static_cast<std::uint8_t>((known[row] & ~own) | (now[row] & own));
  make_shape<D, Pack>(body, slot);
}

/// Bonds for which K⁻¹ was computed. `known`: of eight slots, or of all.
template <class Bonds>
struct KnownBonds : Bonds {
  std::uint8_t* known;
  const Family* family = nullptr;
  std::uint8_t* bytes(std::size_t eight) const { return family ? known + family->begin(eight) : known; }
  BitsOfPack bits(std::size_t slot) const { return {bytes(slot / byte_lanes), slot % byte_lanes}; }
};

}  // namespace perimpact::correspondence
