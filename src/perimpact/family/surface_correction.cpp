#include "perimpact/family/surface_correction.hpp"

#include <cmath>

#include "fccda/core/parallel.hpp"

namespace perimpact {

Vec3d interpolation_weights(const Vec3d& n) {
  Vec3d half{0.5 * n.x * n.x, 0.5 * n.y * n.y, 0};
  const double first_two = std::fma(half.y, 2.0, 2.0 * half.x);
  half.z = 0.5 * (1 - first_two);  // in the x-y plane: what rounding leaves, which makes the sum exact there too
  return half;
}

namespace {

/// What one bond adds to the sums of a pull and of a unit strain along each axis.
struct AxisTerms {
  Vec3d energy, dilatation;
};

std::vector<AxisTerms> axis_terms(const Stencil& stencil, double poissons_ratio) {
  std::vector<AxisTerms> terms;
  for (const StencilBond& bond : stencil.bonds()) {
    AxisTerms& added = terms.emplace_back();
    for (std::size_t p = 0; p < 3; ++p) {
      const double stretch = stretch_of_unit_pull(bond, p, poissons_ratio);
      added.energy[p] = stretch * stretch * bond.length * bond.volume;
      added.dilatation[p] = bond.direction[p] * bond.direction[p] * bond.volume;
    }
  }
  return terms;
}

/// whole/part, axis by axis; 1 where there is no bond along an axis, and so nothing to correct.
Vec3d ratios(const Vec3d& whole, const Vec3d& part) {
  Vec3d g;
  for (std::size_t p = 0; p < 3; ++p) g[p] = part[p] > 0 ? whole[p] / part[p] : 1;
  return g;
}

Vec3d times(const Vec3d& a, const Vec3d& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// Calls f(slot) for each particle.
template <class F>
void for_each_particle(const Particles& particles, const F& f) {
  fccda::parallel_for(static_cast<std::ptrdiff_t>(particles.size()),
                      [&](std::ptrdiff_t particle) { f(particles.slot_of()[static_cast<std::size_t>(particle)]); });
}

/// Particles that miss a bond, or that have one to a particle that is marked in `seeds` where that is given.
std::vector<std::uint8_t> marked(const LatticeFamily& family, const Particles& particles, const std::vector<std::uint8_t>* seeds) {
  std::vector<std::uint8_t> marks(particles.lattice().slots(), 0);
  for_each_particle(particles, [&](std::size_t slot) {
    for (std::size_t b = 0; b < family.stencil().size() && !marks[slot]; ++b) {
      const bool intact = family.is_intact(slot, b);
      marks[slot] = seeds ? intact && (*seeds)[slot + static_cast<std::size_t>(family.offsets()[b])] : !intact;
    }
    if (seeds && (*seeds)[slot]) marks[slot] = 1;
  });
  return marks;
}

}  // namespace

CorrectionFactors::CorrectionFactors(SurfaceCorrection kind, double poissons_ratio, const LatticeFamily& family, const Particles& particles) : kind_(kind) {
  const std::size_t slots = particles.lattice().slots();
  plain_.assign(slots / fccda::byte_lanes, 1);
  if (kind == SurfaceCorrection::none) return;

  // Only particles at the surface, and those bonded to them, have factors other than 1; only packs bonded to these need them.
  std::vector<std::uint8_t> changed = marked(family, particles, nullptr);
  if (kind == SurfaceCorrection::energy) {
    changed = marked(family, particles, &changed);
    balance_energy(poissons_ratio, family, particles, changed);
  } else {
    weigh_volume(family, particles);
  }
  const std::vector<std::uint8_t> touched = marked(family, particles, &changed);
  for (std::size_t slot = 0; slot < slots; ++slot)
    if (touched[slot]) plain_[slot / fccda::byte_lanes] = 0;
}

void CorrectionFactors::balance_energy(double poissons_ratio, const LatticeFamily& family, const Particles& particles,
                                       const std::vector<std::uint8_t>& changed) {
  stretch_ = VectorArray(particles.lattice().slots(), particles.slack(), 1);
  dilatation_ = stretch_;
  const std::vector<AxisTerms> terms = axis_terms(family.stencil(), poissons_ratio);
  std::vector<Vec3d> weights;
  AxisTerms whole{};
  for (std::size_t b = 0; b < terms.size(); ++b) {
    weights.push_back(interpolation_weights(family.stencil().bonds()[b].direction));
    whole.energy += terms[b].energy, whole.dilatation += terms[b].dilatation;
  }
  for (int sweep = 0; sweep <= sweeps; ++sweep) {  // the first makes the g_p of Madenci and Oterkus
    VectorArray next_stretch = stretch_, next_dilatation = dilatation_;
    for_each_particle(particles, [&](std::size_t slot) {
      if (!changed[slot]) return;
      AxisTerms part{};
      for (std::size_t b = 0; b < terms.size(); ++b) {
        if (!family.is_intact(slot, b)) continue;
        const std::size_t j = slot + static_cast<std::size_t>(family.offsets()[b]);
        part.energy += dot(weights[b], stretch_.at(slot) + stretch_.at(j)) * terms[b].energy;
        part.dilatation += dot(weights[b], dilatation_.at(slot) + dilatation_.at(j)) * terms[b].dilatation;
      }
      next_stretch.set(slot, times(stretch_.at(slot), ratios(whole.energy, part.energy)));
      next_dilatation.set(slot, times(dilatation_.at(slot), ratios(whole.dilatation, part.dilatation)));
    });
    stretch_ = std::move(next_stretch), dilatation_ = std::move(next_dilatation);
  }
}

void CorrectionFactors::weigh_volume(const LatticeFamily& family, const Particles& particles) {
  volume_ = ScalarArray(particles.lattice().slots(), particles.slack(), 0.5);
  double whole = 0;
  for (const StencilBond& bond : family.stencil().bonds()) whole += bond.volume;
  for_each_particle(particles, [&](std::size_t slot) { volume_.component(0)[slot] = 0.5 * family.initial_volume(slot) / whole; });
}

double CorrectionFactors::stretch_factor(std::size_t i, std::size_t j, const Vec3d& weights) const {
  if (kind_ == SurfaceCorrection::none) return 1;
  if (kind_ == SurfaceCorrection::volume) return 1 / (volume_.component(0)[i] + volume_.component(0)[j]);
  const Vec3d sum = stretch_.at(i) + stretch_.at(j);
  return std::fma(weights.z, sum.z, std::fma(weights.y, sum.y, weights.x * sum.x));
}

}  // namespace perimpact
