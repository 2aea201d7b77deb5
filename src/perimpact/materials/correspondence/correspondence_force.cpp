#include "perimpact/materials/correspondence/correspondence_force.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "base/parallel.hpp"
#include "perimpact/force/bond_loop.hpp"

namespace perimpact {

using namespace fccda;

namespace {

/// Topological distance of eight slots from the bonds that broke in a pass.
enum Nearness : std::uint8_t {
  far_off,
  beside_changed,  ///< has a neighbour whose energy changed
  changed,         ///< a neighbour lost bonds, which changed its own energy
  broke_here
};

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

/// Computes K⁻¹ and χ of the particles of one pack from their intact bonds.
template <std::size_t D, class Pack, class View>
void make_shape(const View& body, std::size_t slot) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  SmallMatrix<Pack, D> shape;
  for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    add_outer(shape, xi, xi, select(bond.intact, body.shapes.template weight<Pack>(bond.index)));
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

/// Residual of the bonds of a pack: Σ ω |z|² v V [m⁵].
template <std::size_t D, class Pack, class View>
Pack remainder_of_pack(const View& body, std::size_t slot, const SmallMatrix<Pack, D>& gradient) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  Pack sum(0.0);
  for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    Pack squares(0.0);
    for (std::size_t r = 0; r < D; ++r) {
      Pack z = bond.between[r];
      for (std::size_t s = 0; s < D; ++s) z = z - gradient.m[r][s] * xi[s];
      squares = fused_multiply_add(z, z, squares);
    }
    sum = fused_multiply_add(select(bond.intact, body.shapes.template weight<Pack>(bond.index)), squares, sum);
  });
  return sum;
}

/// Bonds for which K⁻¹ was computed. `known`: of eight slots, or of all.
template <class Bonds>
struct KnownBonds : Bonds {
  std::uint8_t* known;
  const Family* family = nullptr;
  std::uint8_t* bytes(std::size_t eight) const { return family ? known + family->begin(eight) : known; }
};

/// Energy W - dt W'/2 [J] of the particles of a pack in the middle of the last step, from these bonds and the cached K⁻¹ and χ.
template <std::size_t D, class Pack, class View>
[[gnu::noinline, gnu::cold]] double energy_amid_step(const View& body, std::size_t slot, double dt) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  SmallMatrix<Pack, D> moment;
  for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{}, [&](const auto& bond) {
    add_outer(moment, bond.between, body.shapes.template reference<Pack>(bond, of_i), select(bond.intact, body.shapes.template weight<Pack>(bond.index)));
  });
  const auto response = body.law.respond(moment, inverse_shape_of<D, Pack>(body, slot), load<Pack>(body.shape[D * (D + 1) / 2] + slot));
  const std::array<const double*, 3> v = body.particles.velocity.pointers();
  Pack power(0.0);  // Σ t·(v_j - v_i) [W/m³]
  for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    Pack sum(0.0);
    for (std::size_t r = 0; r < 3; ++r) {
      Pack pull = response.along * bond.between[r];
      if (r < D)
        for (std::size_t s = 0; s < D; ++s) pull = fused_multiply_add(response.through.m[r][s], xi[s], pull);
      sum = fused_multiply_add(pull, bond.neighbour.of(v[r]) - load<Pack>(v[r] + slot), sum);
    }
    power = fused_multiply_add(select(bond.intact, body.shapes.template weight<Pack>(bond.index)), sum, power);
  });
  const Pack energy = fused_multiply_add(Pack(0.5) * response.along, remainder_of_pack<D, Pack>(body, slot, response.gradient), response.energy);
  return energy_of_pack(fused_multiply_add(Pack(-0.5 * dt), power, energy), body.particles, slot);
}

/// Computes B and c of the particles of one pack; returns their energy density [J/m³] if with_energy. Adds the released energy to `fracture` [J].
template <std::size_t D, class Pack, class View, class Breaking>
Pack response_of_pack(const View& body, std::size_t slot, const Breaking& breaking, std::uint8_t* known, const PassOptions& options, double& fracture) {
  if constexpr (Breaking::is_armed) follow_bonds<D, Pack>(body, slot, known);  // as after a restart: failure in this pass is counted from the current bonds
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  [[maybe_unused]] bool broke = false;
  SmallMatrix<Pack, D> moment;
  for_each_bond<Pack>(
      body.bonds, body.x, slot, breaking,
      [&](const auto& bond) {
        add_outer(moment, bond.between, body.shapes.template reference<Pack>(bond, of_i), select(bond.intact, body.shapes.template weight<Pack>(bond.index)));
      },
      [&](const auto&) { broke = true; });
  if (broke) [[unlikely]] {
    using Bonds = std::decay_t<decltype(body.bonds)>;
    BodyView<D, KnownBonds<Bonds>, std::decay_t<decltype(body.shapes)>> before{
        body.particles, body.x, KnownBonds<Bonds>{body.bonds, known}, body.shapes, body.law, body.shape, body.bound_at_first, body.response, {}, {}, {},
        body.family};
    fracture += energy_amid_step<D, Pack>(before, slot, options.dt);
  }
  follow_bonds<D, Pack>(body, slot, known);
  if (broke) [[unlikely]]
    fracture -= energy_amid_step<D, Pack>(body, slot, options.dt);
  const auto response = body.law.respond(moment, inverse_shape_of<D, Pack>(body, slot), load<Pack>(body.shape[D * (D + 1) / 2] + slot));
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) store(body.response[r * D + s] + slot, response.through.m[r][s]);
  store(body.response[D * D] + slot, response.along);
  if (!options.with_energy) return Pack(0.0);
  return fused_multiply_add(Pack(0.5) * response.along, remainder_of_pack<D, Pack>(body, slot, response.gradient), response.energy);
}

// -- stabilisation bond-level ------------------------------------------------------------------------------------------

template <class Pack, std::size_t N>
Pack remaining_of(const std::array<double*, N>& shape, std::size_t slot) {
  return load<Pack>(shape[N - 2] + slot);  // χ
}

template <std::size_t D, class Pack>
SmallMatrix<Pack, D> load_matrix(const std::array<double*, D * D>& from, std::size_t slot) {
  SmallMatrix<Pack, D> matrix;
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) matrix.m[r][s] = load<Pack>(from[r * D + s] + slot);
  return matrix;
}

template <std::size_t D, class Pack>
void store_matrix(const std::array<double*, D * D>& to, std::size_t slot, const SmallMatrix<Pack, D>& matrix) {
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) store(to[r * D + s] + slot, matrix.m[r][s]);
}

/// (own - neighbour's) ξ for one bond of each particle of a pack.
template <std::size_t D, class Pack, class Bond>
Vec3<Pack> difference_along(const SmallMatrix<Pack, D>& own, const std::array<double*, D * D>& all, const Bond& bond, const Vec3<Pack>& xi) {
  Vec3<Pack> difference{Pack(0.0), Pack(0.0), Pack(0.0)};
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s) difference[r] = fused_multiply_add(own.m[r][s] - bond.neighbour.of(all[r * D + s]), xi[s], difference[r]);
  return difference;
}

/// Stores F of the particles of one pack, from their moment Σ ω y⊗ξ v V.
template <std::size_t D, class Pack, class View>
void store_gradient(const View& body, std::size_t slot, const SmallMatrix<Pack, D>& moment) {
  store_matrix<D>(body.gradient, slot, Correspondence::gradient(moment, inverse_shape_of<D, Pack>(body, slot), remaining_of<Pack>(body.shape, slot)));
}

/// Moment Σ ω a⊗ξ v V of the particles of one pack, with a the differences of velocities or positions to their neighbours: for dF/dt or F.
template <std::size_t D, class Pack, class View>
SmallMatrix<Pack, D> moment_of_pack(const View& body, std::size_t slot, const std::array<const double*, 3>& of) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  SmallMatrix<Pack, D> moment;
  for_each_bond<Pack>(body.bonds, of, slot, Unbreakable{}, [&](const auto& bond) {
    add_outer(moment, bond.between, body.shapes.template reference<Pack>(bond, of_i), select(bond.intact, body.shapes.template weight<Pack>(bond.index)));
  });
  return moment;
}

/// Energy density W - dt W'/2 [J/m³] of the particles of one pack, from the stored gradients (and their rates).
template <std::size_t D, class Pack, bool with_rate, class View>
[[gnu::noinline]] Pack bond_level_energy(const View& body, std::size_t slot, [[maybe_unused]] double dt) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  const SmallMatrix<Pack, D> gradient = load_matrix<D, Pack>(body.gradient, slot);
  [[maybe_unused]] SmallMatrix<Pack, D> rate, turning_rate;
  if constexpr (with_rate) rate = load_matrix<D, Pack>(body.rate, slot);
  SmallMatrix<Pack, D> turning;  // T
  Pack residual(0.0), difference(0.0);
  [[maybe_unused]] Pack residual_rate(0.0), difference_rate(0.0);
  [[maybe_unused]] const std::array<const double*, 3> v = body.particles.velocity.pointers();
  for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    const Pack weight = select(bond.intact, body.shapes.template weight<Pack>(bond.index));
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
    energy = fused_multiply_add(Pack(-0.5 * dt), power, energy);
  }
  return energy;
}

/// F¹ of the particles of one pack, its stress Q = χ P K⁻¹, and the part of B without the stresses of neighbours.
template <std::size_t D, class Pack, class View>
void bond_level_stress(const View& body, std::size_t slot) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  const SmallMatrix<Pack, D> gradient = load_matrix<D, Pack>(body.gradient, slot), inverse = inverse_shape_of<D, Pack>(body, slot);
  SmallMatrix<Pack, D> turning;  // T
  for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    const Pack weight = select(bond.intact, body.shapes.template weight<Pack>(bond.index));
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
void bond_level_return(const View& body, std::size_t slot) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  const SmallMatrix<Pack, D> carried = load_matrix<D, Pack>(body.carried, slot);
  const Pack remaining = remaining_of<Pack>(body.shape, slot);
  SmallMatrix<Pack, D> sum;
  for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    const Pack of_j = bond.neighbour.of(body.shape[body.shape.size() - 2]);
    Vec3<Pack> d{Pack(0.0), Pack(0.0), Pack(0.0)};
    for (std::size_t r = 0; r < D; ++r)
      for (std::size_t s = 0; s < D; ++s)
        d[r] = fused_multiply_add(fused_multiply_add(of_j, carried.m[r][s], Pack(-1.0) * remaining * bond.neighbour.of(body.carried[r * D + s])), xi[s], d[r]);
    add_outer(sum, d, xi, select(bond.intact, body.shapes.template weight<Pack>(bond.index)));
  });
  const SmallMatrix<Pack, D> returned = sum * inverse_shape_of<D, Pack>(body, slot);
  for (std::size_t r = 0; r < D; ++r)
    for (std::size_t s = 0; s < D; ++s)
      store(body.response[r * D + s] + slot, fused_multiply_add(Pack(0.5), returned.m[r][s], load<Pack>(body.response[r * D + s] + slot)));
}

/// Computes F of the particles of one pack, with bond failure. Packs that lost bonds are completed by account_for_broken().
template <std::size_t D, class Pack, class View, class Breaking>
void gradient_of_pack(const View& body, std::size_t slot, const Breaking& breaking, std::uint8_t* known, std::uint8_t* broken) {
  if constexpr (Breaking::is_armed) follow_bonds<D, Pack>(body, slot, known);
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  [[maybe_unused]] bool broke = false;
  SmallMatrix<Pack, D> moment;
  for_each_bond<Pack>(
      body.bonds, body.x, slot, breaking,
      [&](const auto& bond) {
        add_outer(moment, bond.between, body.shapes.template reference<Pack>(bond, of_i), select(bond.intact, body.shapes.template weight<Pack>(bond.index)));
      },
      [&](const auto&) { broke = true; });
  if (broke) [[unlikely]] {
    broken[slot / byte_lanes] = broke_here;
    return;
  }
  if constexpr (!Breaking::is_armed) follow_bonds<D, Pack>(body, slot, known);
  store_gradient<D, Pack>(body, slot, moment);
}

/// Force density of the particles of one pack.
template <std::size_t D, class Pack, class View>
void force_of_pack(const View& body, std::size_t slot, VectorArray& force_density) {
  const auto of_i = body.shapes.template of_particle<Pack>(slot);
  Pack own[D * D + 1], force[3]{};
  for (std::size_t n = 0; n <= D * D; ++n) own[n] = load<Pack>(body.response[n] + slot);
  for_each_bond<Pack>(body.bonds, body.x, slot, Unbreakable{}, [&](const auto& bond) {
    const Vec3<Pack> xi = body.shapes.template reference<Pack>(bond, of_i);
    const Pack weight = select(bond.intact, body.shapes.template weight<Pack>(bond.index));
    const Pack along = own[D * D] + bond.neighbour.of(body.response[D * D]);
    for (std::size_t r = 0; r < D; ++r) {
      Pack pull = along * bond.between[r];
      for (std::size_t s = 0; s < D; ++s) pull = fused_multiply_add(own[r * D + s] + bond.neighbour.of(body.response[r * D + s]), xi[s], pull);
      force[r] = fused_multiply_add(weight, pull, force[r]);
    }
  });
  for (std::size_t c = 0; c < 3; ++c) store(force_density.component(c) + slot, force[c]);
}

}  // namespace

template <std::size_t D>
template <class Visit>
void CorrespondenceForce<D>::with_bonds(const Particles& particles, Family& family, const Visit& visit) {
  const auto view = [&]<class Bonds, class Shapes>(const Bonds& bonds, const Shapes& shapes) {
    BodyView<D, Bonds, Shapes> body{particles, particles.position.pointers(), bonds, shapes, law_, {}, bound_at_first_.data(), {}, {}, {}, {}, &family};
    for (std::size_t n = 0; n < symmetric + 2; ++n) body.shape[n] = shape_.component(n);
    for (std::size_t n = 0; n < loads; ++n) body.response[n] = response_.component(n);
    for (std::size_t n = 0; n < D * D && gradient_.slots() != 0; ++n) body.gradient[n] = gradient_.component(n), body.carried[n] = carried_.component(n);
    for (std::size_t n = 0; n < D * D && rate_.slots() != 0; ++n) body.rate[n] = rate_.component(n);
    visit(body);
  };
  if (family.list())
    view(ListedBonds(family), ListShapes{reference_.pointers(), listed_weighted_volume_.data()});
  else
    view(StencilBonds(family), StencilShapes{bonds_, weighted_volume_});
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
    for (std::size_t entry = 0; entry < list.length.size(); ++entry) listed_weighted_volume_.push_back(law_.weight(list.length[entry]) * list.volume[entry]);
  }
  with_bonds(particles, family, [&](const auto& body) {
    // packs of fewer lanes than a byte share bytes of known_: one thread takes all packs of a byte
    parallel_for(static_cast<std::ptrdiff_t>(particles.slots() / byte_lanes), [&](std::ptrdiff_t eight) {
      const std::size_t begin = static_cast<std::size_t>(eight) * byte_lanes;
      for (std::size_t slot = begin; slot < begin + byte_lanes; slot += lanes<NativePack>)
        follow_bonds<D, NativePack>(body, slot, known_.data() + family.begin(begin / byte_lanes));
    });
  });
  std::copy_n(shape_.component(symmetric + 1), particles.slots(), bound_at_first_.begin());  // here χ is 1, or 0 where the bound is 0
}

template <std::size_t D>
template <class Pack, class View>
[[gnu::noinline, gnu::cold]] void CorrespondenceForce<D>::account_for_broken(const View& body, const Particles& particles, double dt, RowSums& rows) {
  using Bonds = std::decay_t<decltype(body.bonds)>;
  const Family& family = *body.family;
  const BodyView<D, KnownBonds<Bonds>, std::decay_t<decltype(body.shapes)>> before{
      body.particles,      body.x,        KnownBonds<Bonds>{body.bonds, known_.data(), &family},
      body.shapes,         body.law,      body.shape,
      body.bound_at_first, body.response, body.gradient,
      body.carried,        body.rate,     body.family};
  // a broken bond changes F at its ends, and thus the energy of their families, which needs dF/dt of the families of these
  for (const std::uint8_t from : {broke_here, changed})
    for (std::size_t eight = 0; eight < broken_.size(); ++eight) {
      if (broken_[eight] < from) continue;
      for (std::size_t slot = eight * byte_lanes; slot < (eight + 1) * byte_lanes; slot += lanes<Pack>)
        for_each_bond<Pack>(before.bonds, body.x, slot, Unbreakable{}, [&](const auto& bond) {
          for_each_bit(bond.intact, [&](std::size_t lane) {
            std::uint8_t& of_j = broken_[bond.neighbour.slot_of(lane) / byte_lanes];
            of_j = std::max(of_j, static_cast<std::uint8_t>(from - 1));
          });
        });
    }
  const auto for_each = [&](Nearness least, const auto& f) {
    for_each_pack<Pack>(particles, [&](std::size_t row, std::size_t slot) {
      if (broken_[slot / byte_lanes] >= least) f(row, slot);
    });
  };
  const auto make_gradient = [](const auto& view, std::size_t slot) { store_gradient<D, Pack>(view, slot, moment_of_pack<D, Pack>(view, slot, view.x)); };
  const auto make_rate = [](const auto& view, std::size_t slot) {
    store_matrix<D>(view.rate, slot, moment_of_pack<D, Pack>(view, slot, view.particles.velocity.pointers()) * inverse_shape_of<D, Pack>(view, slot));
  };
  const auto add_energy = [&](const auto& view, double sign) {
    for_each(changed, [&](std::size_t row, std::size_t slot) {
      rows.fracture_energy[row] += sign * energy_of_pack(bond_level_energy<D, Pack, true>(view, slot, dt), particles, slot);
    });
  };
  for_each(broke_here, [&](std::size_t, std::size_t slot) { make_gradient(before, slot); });
  for_each(beside_changed, [&](std::size_t, std::size_t slot) { make_rate(before, slot); });
  add_energy(before, 1);
  for_each(broke_here, [&](std::size_t, std::size_t slot) {
    follow_bonds<D, Pack>(body, slot, known_.data() + family.begin(slot / byte_lanes));
    make_gradient(body, slot);
    make_rate(body, slot);
  });
  add_energy(body, -1);
  std::fill(broken_.begin(), broken_.end(), std::uint8_t{far_off});
}

template <std::size_t D>
template <class Pack, class View>
void CorrespondenceForce<D>::bond_level_pass(const View& body, Particles& particles, Family& family, const PassOptions& options, RowSums& rows) {
  breaking_.template for_each_pack<Pack>(body.bonds, particles, family, options, rows, [&](std::size_t, std::size_t slot, const auto& breaker) {
    gradient_of_pack<D, Pack>(body, slot, breaker, known_.data() + family.begin(slot / byte_lanes), broken_.data());
    return 0.0;
  });
  if (std::find(broken_.begin(), broken_.end(), broke_here) != broken_.end()) account_for_broken<Pack>(body, particles, options.dt, rows);
  for_each_pack<Pack>(particles, [&](std::size_t row, std::size_t slot) {
    bond_level_stress<D, Pack>(body, slot);
    if (options.with_energy) rows.energy[row] += energy_of_pack(bond_level_energy<D, Pack, false>(body, slot, 0), particles, slot);
  });
  for_each_pack<Pack>(particles, [&](std::size_t, std::size_t slot) { bond_level_return<D, Pack>(body, slot); });
  for_each_pack<Pack>(particles, [&](std::size_t, std::size_t slot) { force_of_pack<D, Pack>(body, slot, particles.force_density); });
}

template <std::size_t D>
template <class Pack>
void CorrespondenceForce<D>::pass(Particles& particles, Family& family, const PassOptions& options, RowSums& rows) {
  with_bonds(particles, family, [&](const auto& body) {
    if (law_.is_bond_level()) return bond_level_pass<Pack>(body, particles, family, options, rows);
    breaking_.template for_each_pack<Pack>(body.bonds, particles, family, options, rows, [&](std::size_t row, std::size_t slot, const auto& breaker) {
      const Pack density = response_of_pack<D, Pack>(body, slot, breaker, known_.data() + family.begin(slot / byte_lanes), options, rows.fracture_energy[row]);
      return options.with_energy ? energy_of_pack(density, particles, slot) : 0.0;
    });
    for_each_pack<Pack>(particles, [&](std::size_t, std::size_t slot) { force_of_pack<D, Pack>(body, slot, particles.force_density); });
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
double CorrespondenceForce<D>::bytes() const {
  const std::size_t doubles = shape_.slots() * (symmetric + 3 + loads) + D * D * (gradient_.slots() + carried_.slots() + rate_.slots()) +
                              3 * reference_.slots() + listed_weighted_volume_.size();
  return breaking_.bytes() + static_cast<double>(sizeof(double) * doubles + known_.size() + broken_.size());
}

template class CorrespondenceForce<2>;
template class CorrespondenceForce<3>;
template void CorrespondenceForce<2>::pass<double>(Particles&, Family&, const PassOptions&, RowSums&);
template void CorrespondenceForce<3>::pass<double>(Particles&, Family&, const PassOptions&, RowSums&);
#if defined(__AVX2__) && !defined(FCCDA_SCALAR_PACK)
template void CorrespondenceForce<2>::pass<NativePack>(Particles&, Family&, const PassOptions&, RowSums&);
template void CorrespondenceForce<3>::pass<NativePack>(Particles&, Family&, const PassOptions&, RowSums&);
#endif

}  // namespace perimpact
