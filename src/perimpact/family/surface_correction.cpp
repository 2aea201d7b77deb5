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

/// Unit strain along each axis, summed over a family.
struct AxisSums {
  Vec3d energy{}, dilatation{};

  void add(const StencilBond& bond) {
    const Vec3d n2{bond.direction.x * bond.direction.x, bond.direction.y * bond.direction.y, bond.direction.z * bond.direction.z};
    for (std::size_t p = 0; p < 3; ++p) {
      energy[p] += n2[p] * n2[p] * bond.length * bond.volume;
      dilatation[p] += n2[p] * bond.volume;
    }
  }
};

Vec3d ratios(const Vec3d& whole, const Vec3d& part) {
  Vec3d g;
  for (std::size_t p = 0; p < 3; ++p) g[p] = part[p] > 0 ? whole[p] / part[p] : 1;  // no bond along p: nothing to correct
  return g;
}

}  // namespace

CorrectionFactors::CorrectionFactors(SurfaceCorrection kind, const LatticeFamily& family, const Particles& particles) : kind_(kind) {
  const std::size_t slots = particles.lattice().slots();
  const std::size_t eights = slots / fccda::byte_lanes;
  plain_.assign(eights, 1);
  if (kind == SurfaceCorrection::none) return;

  if (kind == SurfaceCorrection::energy) {
    stretch_ = VectorArray(slots, particles.slack(), 1);
    dilatation_ = VectorArray(slots, particles.slack(), 1);
  } else {
    volume_ = ScalarArray(slots, particles.slack(), 0.5);
  }

  const auto& bonds = family.stencil().bonds();
  AxisSums whole;
  double whole_volume = 0;
  for (const StencilBond& bond : bonds) whole.add(bond), whole_volume += bond.volume;

  std::vector<std::uint8_t> at_surface(slots, 0);
  fccda::parallel_for(static_cast<std::ptrdiff_t>(particles.size()), [&](std::ptrdiff_t particle) {
    const std::size_t slot = particles.slot_of()[static_cast<std::size_t>(particle)];
    AxisSums part;
    double part_volume = 0;
    bool full = true;
    for (std::size_t b = 0; b < bonds.size(); ++b) {
      if (family.is_intact(slot, b)) part.add(bonds[b]), part_volume += bonds[b].volume;
      else full = false;
    }
    if (full) return;  // factors stay exactly 1
    at_surface[slot] = 1;
    if (kind == SurfaceCorrection::energy) {
      stretch_.set(slot, ratios(whole.energy, part.energy));
      dilatation_.set(slot, ratios(whole.dilatation, part.dilatation));
    } else {
      volume_.component(0)[slot] = 0.5 * part_volume / whole_volume;
    }
  });

  const Lattice& lattice = particles.lattice();
  fccda::parallel_for(static_cast<std::ptrdiff_t>(eights), [&](std::ptrdiff_t eight) {
    for (std::size_t slot = static_cast<std::size_t>(eight) * 8; slot < static_cast<std::size_t>(eight) * 8 + 8; ++slot) {
      if (!particles.is_occupied(slot)) continue;
      if (at_surface[slot]) plain_[static_cast<std::size_t>(eight)] = 0;
      const auto [i, j, k] = lattice.cell(slot);
      for (const StencilBond& bond : bonds)
        if (lattice.contains(i + bond.di, j + bond.dj, k + bond.dk) && at_surface[lattice.slot(i + bond.di, j + bond.dj, k + bond.dk)])
          plain_[static_cast<std::size_t>(eight)] = 0;
    }
  });
}

double CorrectionFactors::stretch_factor(std::size_t i, std::size_t j, const Vec3d& weights) const {
  if (kind_ == SurfaceCorrection::none) return 1;
  if (kind_ == SurfaceCorrection::volume) return 1 / (volume_.component(0)[i] + volume_.component(0)[j]);
  const Vec3d sum = stretch_.at(i) + stretch_.at(j);
  return std::fma(weights.z, sum.z, std::fma(weights.y, sum.y, weights.x * sum.x));
}

}  // namespace perimpact
