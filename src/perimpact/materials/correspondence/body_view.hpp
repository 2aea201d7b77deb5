/// Data that the kernels of the correspondence material read and write, and the shape tensors of packs of particles.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "base/host_device.hpp"
#include "perimpact/force/bond_loop.hpp"
#include "perimpact/force/pass.hpp"
#include "perimpact/materials/correspondence/correspondence.hpp"
#include "perimpact/particles/particles_view.hpp"

namespace perimpact::correspondence {

using namespace fccda;

/// Reference vectors ξ and weights ω v V of the bonds of a stencil.
struct StencilShapes {
  const Vec3d* bonds;
  const double* weighted_volume;

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    visit(bonds), visit(weighted_volume);
  }
  template <class Pack>
  struct OfParticle {};
  template <class Pack>
  FCCDA_HD OfParticle<Pack> of_particle(std::size_t) const {
    return {};
  }
  template <class Pack, class Bond>
  FCCDA_HD Vec3<Pack> reference(const Bond& bond, const OfParticle<Pack>&) const {
    const Vec3d& xi = bonds[bond.index];
    return {Pack(xi.x), Pack(xi.y), Pack(xi.z)};
  }
  template <class Pack>
  FCCDA_HD Pack weight(std::size_t index) const {
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
  ParticlesView particles;
  Bonds bonds, known;  // those of now, and those for which K⁻¹ was computed
  Shapes shapes;
  Correspondence law;
  std::array<double*, D*(D + 1) / 2 + 2> shape;
  const double* bound_at_first;
  std::array<double*, D * D + 1> response;
  std::array<double*, D * D> gradient, carried, rate;  // for the stabilisation bond-level
  std::uint8_t* broken;                                // Nearness of each eight, where bonds may break
  std::array<double*, 3> force;                        // [N/m³]
  double dt;                                           // [s], as in PassOptions

  /// All pointers but those of the bonds and `broken`.
  template <class Visit>
  void visit_pointers(const Visit& visit) {
    particles.visit_pointers(visit);
    shapes.visit_pointers(visit);
    visit(bound_at_first);
    const auto visit_all = [&](auto& components) {
      for (double*& component : components) visit(component);
    };
    visit_all(shape), visit_all(response), visit_all(gradient), visit_all(carried), visit_all(rate), visit_all(force);
  }
  /// With the bonds for which K⁻¹ was computed.
  FCCDA_HD BodyView before() const {
    BodyView view = *this;
    view.bonds = known;
    return view;
  }
};

/// Adds ω v V a⊗b for one bond of each particle of a pack.
template <std::size_t D, class Pack>
FCCDA_HD void add_outer(SmallMatrix<Pack, D>& sum, const Vec3<Pack>& a, const Vec3<Pack>& b, Pack weight) {
  for (std::size_t s = 0; s < D; ++s) {
    const Pack weighted = weight * b[s];
    for (std::size_t r = 0; r < D; ++r) sum.m[r][s] = fused_multiply_add(a[r], weighted, sum.m[r][s]);
  }
}

template <std::size_t D, class Pack, class View>
FCCDA_HD SmallMatrix<Pack, D> inverse_shape_of(const View& body, std::size_t slot) {
  SmallMatrix<Pack, D> inverse;
  std::size_t n = 0;
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = r; s < D; ++s) inverse.m[r][s] = inverse.m[s][r] = load<Pack>(body.shape[n++] + slot);
  return inverse;
}

template <class Pack, std::size_t N>
FCCDA_HD Pack remaining_of(const std::array<double*, N>& shape, std::size_t slot) {
  return load<Pack>(shape[N - 2] + slot);  // χ
}

/// Moment Σ ω a⊗ξ v V of the particles of one pack, with a the differences of velocities or positions to their neighbours: for dF/dt or F. Bonds that
/// `breaking` breaks are left out, and set `broke`.
template <std::size_t D, class Pack, class View, class Breaking>
FCCDA_HD SmallMatrix<Pack, D> moment_of_pack(const View& body, std::size_t slot, const std::array<const double*, 3>& of, const Breaking& breaking,
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
FCCDA_HD SmallMatrix<Pack, D> moment_of_pack(const View& body, std::size_t slot, const std::array<const double*, 3>& of) {
  bool none = false;
  return moment_of_pack<D, Pack>(body, slot, of, Unbreakable{}, none);
}

/// Computes K⁻¹ and χ of the particles of one pack from their intact bonds.
template <std::size_t D, class Pack, class View>
FCCDA_HD void make_shape(const View& body, std::size_t slot) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  SmallMatrix<Pack, D> shape;
  for_each_bond<Pack>(body.bonds, body.particles.position, slot, Unbreakable{}, [&](const auto& bond) {
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

/// Copies the bonds of a pack from `now` to `known` if any of its eight have changed; whether they have.
template <class Pack, class Bonds>
FCCDA_HD bool copy_changed_bonds(const Bonds& now, const Bonds& known, std::size_t slot) {
  if constexpr (requires { now.template copy_changed<Pack>(known, slot); }) {  // of a device
    return now.template copy_changed<Pack>(known, slot);
  } else {
    const std::size_t eight = slot / byte_lanes, rows = now.rows(eight);
    const std::uint8_t* const from = now.bytes(eight);
    std::uint8_t* const to = known.bytes(eight);
    if (std::equal(to, to + rows, from)) return false;
    const unsigned own = ((1u << lanes<Pack>)-1u) << (slot % byte_lanes);
    for (std::size_t row = 0; row < rows; ++row) to[row] = static_cast<std::uint8_t>((to[row] & ~own) | (from[row] & own));
    return true;
  }
}

/// Recomputes K⁻¹ and χ of the particles of one pack if their bonds have changed.
template <std::size_t D, class Pack, class View>
FCCDA_HD void follow_bonds(const View& body, std::size_t slot) {
  if (copy_changed_bonds<Pack>(body.bonds, body.known, slot)) make_shape<D, Pack>(body, slot);
}

}  // namespace perimpact::correspondence
