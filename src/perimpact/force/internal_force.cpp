#include "perimpact/force/internal_force.hpp"

#include "fccda/core/parallel.hpp"
#include "perimpact/force/bond_loop.hpp"
#include "perimpact/force/correction_kernels.hpp"

namespace perimpact {

using namespace fccda;

namespace {

/// What all passes over one body read and write.
struct BodyView {
  const Lattice& lattice;
  std::array<const double*, 3> x;
  VectorArray& force;
  double* theta;
  LatticeFamily& family;
  const CorrectionFactors& correction;
  const OrdinaryState& material;
  std::span<const OrdinaryState::Folded> folded;
  std::span<const double> squared_limits;
  std::span<const Vec3d> half_squares;
  std::span<double> energy_of_row;
  std::span<std::size_t> broken_ends_of_row;
};

template <class Pack>
double sum_of_lanes(Pack pack) {
  double values[lanes<Pack>];
  store(values, pack);
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

/// θ of the particles of one pack.
template <class Pack, class Breaking, class Correction>
void dilatation_of_pack(const BodyView& body, std::size_t slot, const Breaking& breaking, const Correction& correction) {
  const auto of_i = correction.template of<Pack>(slot);
  Pack theta(0.0);
  for_each_bond<Pack>(body.x, body.family.offsets(), body.family.bytes(slot / byte_lanes), slot, slot % byte_lanes, breaking, [&](const BondNow<Pack>& bond) {
    const Pack term = OrdinaryState::dilatation(body.folded[bond.index], length_of(bond.squared_length));
    theta += keep_where(bond.intact, correction.template corrected<Pack>(term, of_i, bond.index, bond.j));
  });
  store(body.theta + slot, theta);
}

/// Force density of the particles of one pack; returns their energy density, summed, if asked to.
template <class Pack, bool has_dilatation, bool with_energy, class Breaking, class Correction>
double force_of_pack(const BodyView& body, std::size_t slot, const Breaking& breaking, const Correction& stretch_correction,
                     const Correction& dilatation_correction) {
  const auto stretch_of_i = stretch_correction.template of<Pack>(slot);
  const auto dilatation_of_i = dilatation_correction.template of<Pack>(slot);
  const Pack theta_i = has_dilatation ? load<Pack>(body.theta + slot) : Pack(0.0);
  Vec3<Pack> force{Pack(0.0), Pack(0.0), Pack(0.0)};
  Pack energy(0.0);
  for_each_bond<Pack>(body.x, body.family.offsets(), body.family.bytes(slot / byte_lanes), slot, slot % byte_lanes, breaking, [&](const BondNow<Pack>& bond) {
    const auto& folded = body.folded[bond.index];
    const Pack inverse_length = inverse_square_root(bond.squared_length);
    Pack pull = stretch_correction.template corrected<Pack>(OrdinaryState::stretch_force(folded, inverse_length), stretch_of_i, bond.index, bond.j);
    if constexpr (has_dilatation) {
      const Pack push = OrdinaryState::dilatation_force(folded, theta_i, load<Pack>(body.theta + bond.j));
      pull = fused(dilatation_correction.template corrected<Pack>(push, dilatation_of_i, bond.index, bond.j), inverse_length, pull);
    }
    pull = keep_where(bond.intact, pull);
    force.x = fused(pull, bond.between.x, force.x);
    force.y = fused(pull, bond.between.y, force.y);
    force.z = fused(pull, bond.between.z, force.z);
    if constexpr (with_energy) {
      const Pack stored = OrdinaryState::stretch_energy(folded, bond.squared_length * inverse_length);
      energy += keep_where(bond.intact, stretch_correction.template corrected<Pack>(stored, stretch_of_i, bond.index, bond.j));
    }
  });
  store(body.force.component(0) + slot, force.x);
  store(body.force.component(1) + slot, force.y);
  store(body.force.component(2) + slot, force.z);
  if constexpr (with_energy && has_dilatation) energy += body.material.dilatation_energy(theta_i);
  return with_energy ? sum_of_lanes(energy) : 0.0;
}

/// The two factors of a bond, and the choice of the plain kernel where all of them are 1.
template <class Factor>
struct Corrections {
  Factor stretch, dilatation;
};

/// Calls per_pack(slot, corrections) for all packs of a row, with PlainBonds where no factor differs from 1.
template <class Pack, class Factor, class PerPack>
void for_each_pack(const BodyView& body, std::size_t row, const Corrections<Factor>& corrections, const PerPack& per_pack) {
  const std::size_t begin = row * body.lattice.row_slots(), end = begin + body.lattice.row_slots();
  for (std::size_t slot = begin; slot < end; slot += lanes<Pack>) {
    if (body.correction.is_plain(slot / byte_lanes))
      per_pack(slot, Corrections<PlainBonds>{});
    else
      per_pack(slot, corrections);
  }
}

template <class Pack, class Factor, bool has_dilatation, bool breaks, bool with_energy>
void all_rows(const BodyView& body, const Corrections<Factor>& corrections) {
  const auto breaking_in = [&body](std::size_t row) {
    if constexpr (breaks)
      return BreakBeyond{body.squared_limits, body.broken_ends_of_row[row]};
    else
      return Unbreakable{};
  };
  const std::ptrdiff_t rows = static_cast<std::ptrdiff_t>(body.lattice.rows());
  if constexpr (has_dilatation) {
    parallel_for(rows, [&](std::ptrdiff_t r) {
      const std::size_t row = static_cast<std::size_t>(r);
      const auto breaking = breaking_in(row);
      for_each_pack<Pack>(body, row, corrections,
                          [&](std::size_t slot, const auto& factors) { dilatation_of_pack<Pack>(body, slot, breaking, factors.dilatation); });
    });
  }
  parallel_for(rows, [&](std::ptrdiff_t r) {
    const std::size_t row = static_cast<std::size_t>(r);
    double energy = 0;
    const auto forces = [&](const auto& breaking) {
      for_each_pack<Pack>(body, row, corrections, [&](std::size_t slot, const auto& factors) {
        energy += force_of_pack<Pack, has_dilatation, with_energy>(body, slot, breaking, factors.stretch, factors.dilatation);
      });
    };
    if constexpr (has_dilatation)
      forces(Unbreakable{});  // the dilatation pass has broken what breaks
    else
      forces(breaking_in(row));
    if constexpr (with_energy) body.energy_of_row[row] = energy;
  });
}

/// Calls f with std::true_type or std::false_type.
template <class F>
void with_constant(bool value, const F& f) {
  if (value)
    f(std::true_type{});
  else
    f(std::false_type{});
}

template <class Pack>
void run_pass(const BodyView& body, bool breaks, bool with_energy) {
  with_constant(body.material.needs_dilatation(), [&](auto has_dilatation) {
    with_constant(breaks, [&](auto breaking) {
      with_constant(with_energy, [&](auto energy) {
        const auto run = [&](const auto& corrections) {
          all_rows<Pack, std::decay_t<decltype(corrections.stretch)>, has_dilatation, breaking, energy>(body, corrections);
        };
        switch (body.correction.kind()) {
          case SurfaceCorrection::none:
            run(Corrections<PlainBonds>{});
            break;
          case SurfaceCorrection::energy:
            run(Corrections<EnergyFactor>{{body.correction.stretch().pointers(), body.half_squares},
                                          {body.correction.dilatation().pointers(), body.half_squares}});
            break;
          case SurfaceCorrection::volume: {
            const VolumeFactor factor{body.correction.volume().component(0)};
            run(Corrections<VolumeFactor>{factor, factor});
            break;
          }
        }
      });
    });
  });
}

}  // namespace

InternalForce::InternalForce(OrdinaryState material, const std::optional<CriticalStretch>& breaking, CorrectionFactors correction, const LatticeFamily& family,
                             const Particles& particles)
    : material_(material), breaking_(breaking.has_value()), correction_(std::move(correction)) {
  for (const StencilBond& bond : family.stencil().bonds()) {
    folded_.push_back(material_.fold(bond.length, bond.volume));
    if (breaking) squared_limits_.push_back(breaking->squared_limit(bond.length));
    half_squares_.push_back(interpolation_weights(bond.direction));
  }
  if (material_.needs_dilatation()) theta_ = ScalarArray(particles.lattice().slots(), particles.slack());
  energy_of_row_.assign(particles.lattice().rows(), 0);
  broken_ends_of_row_.assign(particles.lattice().rows(), 0);
}

template <class Pack>
void InternalForce::pass(Particles& particles, LatticeFamily& family, bool with_energy) {
  const BodyView body{particles.lattice(),
                      particles.position.pointers(),
                      particles.force_density,
                      theta_.component(0),
                      family,
                      correction_,
                      material_,
                      folded_,
                      squared_limits_,
                      half_squares_,
                      energy_of_row_,
                      broken_ends_of_row_};
  run_pass<Pack>(body, breaking_, with_energy);
}

void InternalForce::evaluate(Particles& particles, LatticeFamily& family) { pass<NativePack>(particles, family, false); }

double InternalForce::evaluate_with_energy(Particles& particles, LatticeFamily& family) {
  pass<NativePack>(particles, family, true);
  return sum_of_rows(particles);
}

void InternalForce::evaluate_scalar(Particles& particles, LatticeFamily& family) { pass<double>(particles, family, false); }

double InternalForce::sum_of_rows(const Particles& particles) const {
  double sum = 0;
  for (const double energy : energy_of_row_) sum += energy;
  return sum * particles.volume();
}

std::size_t InternalForce::broken_bonds() const {
  std::size_t ends = 0;
  for (const std::size_t count : broken_ends_of_row_) ends += count;
  return ends / 2;
}

}  // namespace perimpact
