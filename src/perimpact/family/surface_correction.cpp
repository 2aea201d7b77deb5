#include "perimpact/family/surface_correction.hpp"

#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>
#include <unordered_map>

#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "perimpact/family/exposure.hpp"

namespace perimpact {

using fccda::byte_lanes, fccda::NativePack;

Vec3d interpolation_weights(const Vec3d& n) {
  Vec3d half{0.5 * n.x * n.x, 0.5 * n.y * n.y, 0};
  const double first_two = std::fma(half.y, 2.0, 2.0 * half.x);
  half.z = 0.5 * (1 - first_two);  // in the x-y plane: the rounding error, so that the sum is exact there too
  return half;
}

namespace {

/// Contribution of one bond to the sums of uniaxial tension and unit strain along each axis.
struct AxisTerms {
  Vec3d energy, dilatation;
};

AxisTerms axis_terms(const CorrectionBasis& basis, const Vec3d& direction, double length, double volume) {
  const double stretch_weight = basis.stretch_weight(length) * volume;
  const double dilatation_weight = basis.dilatation_weight ? basis.dilatation_weight(length) * volume : 0;
  AxisTerms added;
  for (std::size_t p = 0; p < 3; ++p) {
    const double stretch = stretch_of_unit_pull(direction, p, basis.poissons_ratio);
    added.energy[p] = stretch * stretch * stretch_weight;
    added.dilatation[p] = direction[p] * direction[p] * dilatation_weight;
  }
  return added;
}

/// Sums over the bonds of eight slots: energy and dilatation of unit loads along each axis.
struct SumsOfEight {
  double values[6][byte_lanes];

  Vec3d energy(std::size_t lane) const { return {values[0][lane], values[1][lane], values[2][lane]}; }
  Vec3d dilatation(std::size_t lane) const { return {values[3][lane], values[4][lane], values[5][lane]}; }
};

/// The terms of bonds with the present factors of their ends; those of a stencil are tabulated.
class Terms {
 public:
  Terms(const CorrectionBasis& basis, const Family& family) : basis_(basis) {
    if (!family.stencil()) return;
    for (const StencilBond& bond : family.stencil()->bonds()) {
      of_stencil_.push_back(axis_terms(basis, bond.direction, bond.length, bond.volume));
      weights_.push_back(interpolation_weights(bond.direction));
    }
  }

  void sum(const Family& family, std::size_t eight, const VectorArray& stretch, const VectorArray& dilatation, SumsOfEight& sums) const {
    if (family.stencil())
      for (std::size_t lane = 0; lane < byte_lanes; lane += fccda::lanes<NativePack>)
        sum_of_pack<NativePack>(family, eight * byte_lanes + lane, stretch, dilatation, sums);
    else
      for (std::size_t lane = 0; lane < byte_lanes; ++lane) sum_of_list(family, eight * byte_lanes + lane, stretch, dilatation, sums);
  }

 private:
  /// Without fused multiply-adds, as the sum of a complete family.
  template <class Pack>
  void sum_of_pack(const Family& family, std::size_t slot, const VectorArray& stretch, const VectorArray& dilatation, SumsOfEight& sums) const {
    using namespace fccda;
    const std::size_t eight = slot / byte_lanes, first = slot % byte_lanes;
    const std::uint8_t* bytes = family.bytes(eight);
    const std::array<const double*, 3> g = stretch.pointers(), h = dilatation.pointers();
    Pack own_g[3], own_h[3], energy[3] = {}, volume[3] = {};
    for (std::size_t p = 0; p < 3; ++p) own_g[p] = load<Pack>(g[p] + slot), own_h[p] = load<Pack>(h[p] + slot), energy[p] = volume[p] = Pack(0.0);
    const auto mean = [](const Vec3d& weights, const Pack(&own)[3], const std::array<const double*, 3>& all, std::size_t j) {
      return Pack(weights.x) * (own[0] + load<Pack>(all[0] + j)) + Pack(weights.y) * (own[1] + load<Pack>(all[1] + j)) +
             Pack(weights.z) * (own[2] + load<Pack>(all[2] + j));
    };
    for (std::size_t row = 0; row < weights_.size(); ++row) {
      const unsigned intact = pack_bits<Pack>(bytes[row], first);
      if (intact == 0) continue;
      const auto j = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(slot) + family.offsets()[row]);
      const Pack of_energy = mean(weights_[row], own_g, g, j), of_dilatation = mean(weights_[row], own_h, h, j);
      for (std::size_t p = 0; p < 3; ++p) {
        energy[p] = energy[p] + select(intact, of_energy * Pack(of_stencil_[row].energy[p]));
        volume[p] = volume[p] + select(intact, of_dilatation * Pack(of_stencil_[row].dilatation[p]));
      }
    }
    for (std::size_t p = 0; p < 3; ++p) store(sums.values[p] + first, energy[p]), store(sums.values[3 + p] + first, volume[p]);
  }

  void sum_of_list(const Family& family, std::size_t slot, const VectorArray& stretch, const VectorArray& dilatation, SumsOfEight& sums) const {
    AxisTerms part{};
    family.for_each_bond(slot, [&](const FamilyBond& bond) {
      const AxisTerms term = axis_terms(basis_, bond.direction, bond.length, bond.volume);
      const Vec3d weights = interpolation_weights(bond.direction);
      part.energy += dot(weights, stretch.at(slot) + stretch.at(bond.j)) * term.energy;
      part.dilatation += dot(weights, dilatation.at(slot) + dilatation.at(bond.j)) * term.dilatation;
    });
    for (std::size_t p = 0; p < 3; ++p) sums.values[p][slot % byte_lanes] = part.energy[p], sums.values[3 + p][slot % byte_lanes] = part.dilatation[p];
  }

  const CorrectionBasis& basis_;
  std::vector<AxisTerms> of_stencil_;
  std::vector<Vec3d> weights_;
};

/// whole/part along the first axes; 1 without bonds along an axis.
Vec3d ratios(const Vec3d& whole, const Vec3d& part, std::size_t axes) {
  Vec3d g{1, 1, 1};
  for (std::size_t p = 0; p < axes; ++p)
    if (part[p] > 0) g[p] = whole[p] / part[p];
  return g;
}

Vec3d times(const Vec3d& a, const Vec3d& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// Calls f(slot) for each particle.
template <class F>
void for_each_particle(const Particles& particles, const F& f) {
  fccda::parallel_for(static_cast<std::ptrdiff_t>(particles.size()),
                      [&](std::ptrdiff_t particle) { f(particles.slot_of()[static_cast<std::size_t>(particle)]); });
}

/// Calls f(eight) for each eight slots that `wanted` names.
template <class Wanted, class F>
void for_each_eight(const Particles& particles, const Wanted& wanted, const F& f) {
  fccda::parallel_for(static_cast<std::ptrdiff_t>(particles.slots() / byte_lanes), [&](std::ptrdiff_t number) {
    if (const auto eight = static_cast<std::size_t>(number); wanted(eight)) f(eight);
  });
}

using Marks = std::vector<std::uint8_t>;

bool any_of_eight(const Marks& marks, std::size_t eight) {
  std::uint64_t eight_bytes;
  std::memcpy(&eight_bytes, marks.data() + eight * byte_lanes, sizeof eight_bytes);
  return eight_bytes != 0;
}

/// Particles with fewer bonds than the stencil; in a point cloud, all.
Marks incomplete(const Family& family, const Particles& particles) {
  Marks marks(particles.slots(), 0);
  for_each_eight(
      particles, [&](std::size_t eight) { return !family.is_complete(eight); },
      [&](std::size_t eight) {
        const auto bonds = count_bonds(family, eight);
        for (std::size_t lane = 0; lane < byte_lanes; ++lane)
          marks[eight * byte_lanes + lane] = particles.is_occupied(eight * byte_lanes + lane) && !(family.stencil() && bonds[lane] == family.stencil()->size());
      });
  particles.share().refresh({marks.data()});
  return marks;
}

/// Owned particles that are marked or have a marked neighbour; ghosts as their owners mark them.
Marks with_neighbours_of_share(const Marks& marked, const Family& family, const Particles& particles) {
  Marks marks = marked;
  for_each_particle(particles, [&](std::size_t slot) { family.for_each_bond(slot, [&](const FamilyBond& bond) { marks[slot] |= marked[bond.j]; }); });
  particles.share().refresh({marks.data()});
  return marks;
}

/// Marked particles and their neighbours. Bonds are stored at both ends: the marked particles find those that have them as neighbours.
Marks with_neighbours(const Marks& marked, const Family& family, const Particles& particles) {
  Marks marks = marked;
  if (!family.stencil()) return marks;  // all are marked
  if (!particles.share().is_whole()) return with_neighbours_of_share(marked, family, particles);
  for_each_eight(
      particles, [&](std::size_t eight) { return any_of_eight(marked, eight); },
      [&](std::size_t eight) {
        for (std::size_t slot = eight * byte_lanes; slot < (eight + 1) * byte_lanes; ++slot)
          if (marked[slot]) family.for_each_bond(slot, [&](const FamilyBond& bond) { std::atomic_ref(marks[bond.j]).store(1, std::memory_order_relaxed); });
      });
  return marks;
}

}  // namespace

CorrectionFactors::CorrectionFactors(CorrectionKind kind, const CorrectionBasis& basis, const Family& family, const Particles& particles) : kind_(kind) {
  table_of_.assign(particles.slots() / fccda::byte_lanes, 0);
  if (family.stencil()) tables_.emplace_back(family.stencil()->size());
  if (kind == CorrectionKind::none) return;

  // Only particles at the surface, and those bonded to them, have factors other than 1; only packs bonded to these need them.
  Marks changed = incomplete(family, particles);
  switch (kind) {
    case CorrectionKind::energy:
      changed = with_neighbours(changed, family, particles);
      balance_energy(basis, family, particles, changed);
      break;
    case CorrectionKind::volume:
      weigh_volume(basis, family, particles);
      break;
    default:
      weigh_own_family(basis, family, particles);
  }
  const Marks affected = with_neighbours(changed, family, particles);
  for (std::size_t slot = 0; slot < affected.size(); ++slot)
    if (affected[slot]) table_of_[slot / fccda::byte_lanes] = no_table;
  if (family.stencil() && kind != CorrectionKind::family)
    gather_tables(family, particles);  // the factor of a family is squared in the dilatation and not a bond factor
}

void CorrectionFactors::balance_energy(const CorrectionBasis& basis, const Family& family, const Particles& particles,
                                       const std::vector<std::uint8_t>& changed) {
  stretch_ = VectorArray(particles.slots(), particles.slack(), 1);
  if (basis.dilatation_weight) dilatation_ = stretch_;
  const std::size_t axes = particles.is_plane() ? 2 : 3;
  const Terms terms(basis, family);
  Vec3d whole_energy{basis.energy, basis.energy, basis.energy}, whole_dilatation{basis.dilatation, basis.dilatation, basis.dilatation};
  if (const Stencil* stencil = family.stencil()) {  // summed in the order of the kernel, so that a complete family has exactly 1
    whole_energy = whole_dilatation = {};
    for (const StencilBond& bond : stencil->bonds()) {
      const AxisTerms term = axis_terms(basis, bond.direction, bond.length, bond.volume);
      whole_energy += term.energy, whole_dilatation += term.dilatation;
    }
  }
  // the changed particles are few on a lattice; their new numbers are kept apart until all are known
  std::vector<std::uint32_t> eights;
  for (std::size_t eight = 0; eight < table_of_.size(); ++eight)
    if (any_of_eight(changed, eight)) eights.push_back(static_cast<std::uint32_t>(eight));
  std::vector<SumsOfEight> next(eights.size());
  for (int sweep = 0; sweep <= sweeps; ++sweep) {  // the first yields the g_p of Madenci and Oterkus
    fccda::parallel_for(static_cast<std::ptrdiff_t>(eights.size()), [&](std::ptrdiff_t n) {
      SumsOfEight& sums = next[static_cast<std::size_t>(n)];
      terms.sum(family, eights[static_cast<std::size_t>(n)], stretch_, dilatation(), sums);
    });
    fccda::parallel_for(static_cast<std::ptrdiff_t>(eights.size()), [&](std::ptrdiff_t n) {
      const SumsOfEight& sums = next[static_cast<std::size_t>(n)];
      for (std::size_t lane = 0; lane < byte_lanes; ++lane) {
        const std::size_t slot = eights[static_cast<std::size_t>(n)] * byte_lanes + lane;
        if (!changed[slot]) continue;
        stretch_.set(slot, times(stretch_.at(slot), ratios(whole_energy, sums.energy(lane), axes)));
        if (basis.dilatation_weight) dilatation_.set(slot, times(dilatation_.at(slot), ratios(whole_dilatation, sums.dilatation(lane), axes)));
      }
    });
    particles.share().refresh({stretch_.component(0), stretch_.component(1), stretch_.component(2)});
    if (basis.dilatation_weight) particles.share().refresh({dilatation_.component(0), dilatation_.component(1), dilatation_.component(2)});
  }
}

namespace {

/// How often each hash other than 0 occurs on all ranks.
std::unordered_map<std::uint64_t, int> count(std::span<const std::uint64_t> hashes, Ranks& ranks) {
  struct Counted {
    std::uint64_t hash;
    std::int64_t count;
  };
  std::unordered_map<std::uint64_t, int> counts;
  for (const std::uint64_t hash : hashes)
    if (hash != 0) ++counts[hash];
  if (ranks.size() == 1) return counts;
  std::vector<Counted> own;
  for (const auto& [hash, number] : counts) own.push_back({hash, number});
  counts.clear();
  for (const Counted& counted : ranks.join_all(std::span<const Counted>(own))) counts[counted.hash] += static_cast<int>(counted.count);
  return counts;
}

}  // namespace

void CorrectionFactors::gather_tables(const Family& family, const Particles& particles) {
  constexpr int fewest = 4;  // packs per table; fewer cost more memory than they save
  std::vector<Vec3d> weights;
  for (const StencilBond& bond : family.stencil()->bonds()) weights.push_back(interpolation_weights(bond.direction));

  const auto factors_of = [&](std::size_t eight, std::size_t bond, unsigned bits) {  // of the first slot of these
    const std::size_t i = eight * fccda::byte_lanes + static_cast<std::size_t>(std::countr_zero(bits));
    const std::size_t j = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + family.offsets()[bond]);
    return BondFactors{stretch_factor(i, j, weights[bond]), dilatation_factor(i, j, weights[bond])};
  };
  /// The factors of the first of eight slots that has the bond, for each bond; 1 where none has it.
  const auto first_factors = [&](std::size_t eight) {
    std::vector<BondFactors> factors(weights.size());
    for (std::size_t bond = 0; bond < weights.size(); ++bond)
      if (const unsigned bits = family.bytes(eight)[bond]) factors[bond] = factors_of(eight, bond, bits);
    return factors;
  };
  /// True where all of the eight that have a bond agree with the first.
  const auto agree = [&](std::size_t eight, const std::vector<BondFactors>& factors) {
    for (std::size_t bond = 0; bond < weights.size(); ++bond) {
      const unsigned all = family.bytes(eight)[bond];
      for (unsigned others = all & (all - 1); others != 0; others &= others - 1)
        if (!(factors_of(eight, bond, others) == factors[bond])) return false;
    }
    return true;
  };

  const auto eights = static_cast<std::ptrdiff_t>(table_of_.size());
  std::vector<std::uint64_t> hashes(table_of_.size(), 0);  // 0: not shared
  fccda::parallel_for(eights, [&](std::ptrdiff_t e) {
    const auto eight = static_cast<std::size_t>(e);
    if (table_of_[eight] != no_table || !particles.is_owned_eight(eight)) return;
    const std::vector<BondFactors> factors = first_factors(eight);
    if (agree(eight, factors))
      hashes[eight] = std::hash<std::string_view>{}({reinterpret_cast<const char*>(factors.data()), factors.size() * sizeof(BondFactors)}) | 1;
  });
  const std::unordered_map<std::uint64_t, int> packs = count(hashes, particles.share().ranks());  // of the whole body, as the choice affects rounding
  std::unordered_map<std::uint64_t, std::int32_t> table_of_hash;
  for (std::size_t eight = 0; eight < hashes.size(); ++eight)
    if (hashes[eight] != 0 && packs.at(hashes[eight]) >= fewest && table_of_hash.emplace(hashes[eight], static_cast<std::int32_t>(tables_.size())).second)
      tables_.push_back(first_factors(eight));
  fccda::parallel_for(eights, [&](std::ptrdiff_t e) {
    const auto eight = static_cast<std::size_t>(e);
    const auto table = hashes[eight] != 0 ? table_of_hash.find(hashes[eight]) : table_of_hash.end();
    if (table != table_of_hash.end() && first_factors(eight) == tables_[static_cast<std::size_t>(table->second)]) table_of_[eight] = table->second;
  });
}

void CorrectionFactors::weigh_volume(const CorrectionBasis& basis, const Family& family, const Particles& particles) {
  volume_ = ScalarArray(particles.slots(), particles.slack(), 0.5);
  double whole = basis.volume;
  if (const Stencil* stencil = family.stencil()) {
    whole = 0;
    for (const StencilBond& bond : stencil->bonds()) whole += bond.volume;
  }
  for_each_particle(particles, [&](std::size_t slot) { volume_.component(0)[slot] = 0.5 * family.initial_volume(slot) / whole; });
  particles.share().refresh({volume_.component(0)});
}

void CorrectionFactors::weigh_own_family(const CorrectionBasis& basis, const Family& family, const Particles& particles) {
  own_family_ = ScalarArray(particles.slots(), particles.slack(), 0.5);
  double whole = basis.weighted;
  if (const Stencil* stencil = family.stencil()) {
    whole = 0;
    for (const StencilBond& bond : stencil->bonds()) whole += basis.dilatation_weight(bond.length) * bond.volume;
  }
  for_each_particle(particles, [&](std::size_t slot) {
    double own = 0;
    family.for_each_bond(slot, [&](const FamilyBond& bond) { own += basis.dilatation_weight(bond.length) * bond.volume; });
    if (own > 0) own_family_.component(0)[slot] = 0.5 * whole / own;
  });
  particles.share().refresh({own_family_.component(0)});
}

namespace {
double energy_factor(const VectorArray& g, std::size_t i, std::size_t j, const Vec3d& weights) {
  const Vec3d sum = g.at(i) + g.at(j);
  return std::fma(weights.z, sum.z, std::fma(weights.y, sum.y, weights.x * sum.x));
}
}  // namespace

double CorrectionFactors::stretch_factor(std::size_t i, std::size_t j, const Vec3d& weights) const {
  switch (kind_) {
    case CorrectionKind::energy:
      return energy_factor(stretch_, i, j, weights);
    case CorrectionKind::volume:
      return 1 / (volume_.component(0)[i] + volume_.component(0)[j]);
    case CorrectionKind::family:
      return own_family_.component(0)[i] + own_family_.component(0)[j];
    case CorrectionKind::none:
      break;
  }
  return 1;
}

double CorrectionFactors::dilatation_factor(std::size_t i, std::size_t j, const Vec3d& weights) const {
  if (kind_ == CorrectionKind::energy) return dilatation_.slots() != 0 ? energy_factor(dilatation_, i, j, weights) : 1;
  return kind_ == CorrectionKind::volume ? stretch_factor(i, j, weights) : 1;
}

double CorrectionFactors::bytes() const {
  const std::size_t numbers = 3 * (stretch_.slots() + dilatation_.slots()) + volume_.slots() + own_family_.slots();
  const std::size_t tables = tables_.empty() ? 0 : tables_.size() * tables_.front().size() * sizeof(BondFactors);
  return static_cast<double>(sizeof(double) * numbers + sizeof(std::int32_t) * table_of_.size() + tables);
}

}  // namespace perimpact
