// Plastic flow of particles after each evaluation of forces.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "perimpact/damage/strength.hpp"
#include "perimpact/materials/ordinary_state/plastic_force.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

using namespace fccda;

namespace {

constexpr double yields_before_it_breaks = 1e30;  // [1/Pa] slope of the limit of particles that have yielded: no bond breaks under pressure

/// Sets these bits in the marks of the eights of a particle and of those that are bonded to it; several threads may mark.
void mark_family(std::vector<std::uint8_t>& marks, std::uint8_t bits, std::size_t slot, const Family& family) {
  const auto mark_at = [&](std::size_t at) { std::atomic_ref(marks[at / byte_lanes]).fetch_or(bits, std::memory_order_relaxed); };
  mark_at(slot);
  family.for_each_bond(slot, [&](const FamilyBond& bond) { mark_at(bond.j); });
}

}  // namespace

/// Whether a particle was outside of the yield surface by more than is tolerated.
bool PlasticForce::flow(const Particles& particles, const Family& family) {
  std::atomic<bool> overshoots = false;
  parallel_for_uneven(static_cast<std::ptrdiff_t>(particles.rows()), [&](std::ptrdiff_t number) {
    const auto row = static_cast<std::size_t>(number);
    double most = 0;
    const std::size_t begin = row * particles.row_slots(), end = std::min(begin + particles.row_slots(), particles.slots());
    for (std::size_t eight = begin / byte_lanes; eight < end / byte_lanes; ++eight) {
      dissipation_[eight] += pending_[eight];
      pending_[eight] = 0;
      flows_[eight] = static_cast<std::uint8_t>((flows_[eight] & 1u) << 1);
      if (!is_hot_[eight]) continue;
      for (std::size_t slot = eight * byte_lanes; slot < (eight + 1) * byte_lanes; ++slot)
        if (is_stress_known(slot) && particles.owns(slot)) most = std::max(most, flow(slot, particles, family));
    }
    if (most > tolerated_) overshoots.store(true, std::memory_order_relaxed);
  });
  if (particles.share().is_whole()) return overshoots;
  const bool is_hot = std::any_of(is_hot_.begin(), is_hot_.end(), [](std::uint8_t bits) { return bits != 0; });
  std::array<double, 2> of_all{overshoots ? 1.0 : 0.0, is_hot ? 1.0 : 0.0};
  particles.share().ranks().max(of_all);
  if (of_all[1] != 0) refresh_ghosts(particles, family);
  return of_all[0] != 0;
}

/// After flow on any rank.
void PlasticForce::refresh_ghosts(const Particles& particles, const Family& family) {
  std::vector<double*> arrays{equivalent_.component(0), pressure_slope_.component(0), resistance_.component(0)};
  for (std::size_t c = 0; c < 6; ++c) arrays.push_back(strain_.component(c)), arrays.push_back(increment_.component(c));
  particles.share().refresh(std::span<double* const>(arrays));
  mark_ghosts(particles, family);
}

/// Marks the eights beside ghosts that have plastic strain for the first time.
void PlasticForce::mark_ghosts(const Particles& particles, const Family& family) {
  particles.share().for_each_ghost([&](std::size_t ghost) {
    if (equivalent_.component(0)[ghost] == 0 || is_known_ghost_[ghost]) return;
    is_known_ghost_[ghost] = 1;
    family.for_each_end_at_ghost(ghost, particles, [&](std::size_t i, std::size_t row) {
      if ((family.bytes(i / byte_lanes)[row] >> (i % byte_lanes)) & 1u) is_plastic_[i / byte_lanes] = 1;
    });
  });
}

void PlasticForce::derive_from_state(const Particles& particles, const Family& family) {
  find_resistance(particles);
  std::fill(flows_.begin(), flows_.end(), std::uint8_t{1});  // the next flow may change any increment
  parallel_for_blocks(particles.slots(), 256, [&](std::size_t first, std::size_t last) {
    for (std::size_t slot = first; slot < last; ++slot)
      if (particles.owns(slot) && equivalent_.component(0)[slot] > 0) mark_family(is_plastic_, 1, slot, family);
  });
  mark_ghosts(particles, family);
}

/// [Pa] the equivalent stress and the pressure that it removes.
double PlasticForce::flow(std::size_t slot, const Particles& particles, const Family& family) {
  SymmetricTensor stress = tensor_at(stress_, slot);
  const SymmetricTensor before = stress;
  const double half_volume = 0.5 * particles.volume(slot), p = pressure_of(stress);
  dissipation_[slot / byte_lanes] += half_volume * double_contraction(before, tensor_at(increment_, slot));
  SymmetricTensor increment{};
  double overshoot = 0;
  const bool is_crushed = has_failed_[slot] && second_invariant(stress) > plasticity_.residual * p * p;
  if (p > 0 && (is_crushed || plasticity_.ellipse.function(stress) > 0)) {
    flows_[slot / byte_lanes] |= 1;
    increment =
        is_crushed ? return_to_residual(plasticity_.ellipse, plasticity_.residual, moduli_, stress) : return_to_surface(plasticity_.ellipse, moduli_, stress);
    SymmetricTensor removed;
    for (std::size_t c = 0; c < 6; ++c) removed[c] = before[c] - stress[c];
    overshoot = std::sqrt(3 * second_invariant(removed)) + std::fabs(pressure_of(removed));
    SymmetricTensor sum = tensor_at(strain_, slot);
    for (std::size_t c = 0; c < 6; ++c) sum[c] += increment[c];
    set(strain_, slot, sum);
    double& equivalent = equivalent_.component(0)[slot];
    if (equivalent == 0) mark(slot, family);
    equivalent += perimpact::equivalent_strain(increment);
    pending_[slot / byte_lanes] += half_volume * double_contraction(before, increment);
    if (!has_failed_[slot] && breaking_.is_armed() && resistance_.component(0)[slot] < unbreakable &&
        equivalent > plasticity_.failure.at(p / largest_pressure_)) {
      has_failed_[slot] = 1;
      resistance_.component(0)[slot] = 0;
    }
  }
  set(increment_, slot, increment);
  return overshoot;
}

/// From the next pass on the particle and those that are bonded to it know its plastic strain.
void PlasticForce::mark(std::size_t slot, const Family& family) {
  pressure_slope_.component(0)[slot] = yields_before_it_breaks;
  mark_family(is_plastic_, 1, slot, family);
}

/// Finds the eights that the last flow affects: those that contain or are bonded to a particle that flowed and, with a dilatation, those that are bonded
/// to these.
void PlasticForce::mark_affected(const Particles& particles, const Family& family) {
  constexpr std::uint8_t of_strain = 1, of_dilatation = 2;
  std::fill(affected_.begin(), affected_.end(), std::uint8_t{0});
  const auto mark_families_of = [&](std::uint8_t with, const auto& is_source) {
    parallel_for_blocks(affected_.size(), 32, [&](std::size_t first, std::size_t last) {
      for (std::size_t slot = first * byte_lanes; slot < last * byte_lanes; ++slot)
        if (particles.owns(slot) && is_source(slot)) mark_family(affected_, with, slot, family);
    });
  };
  // more packs than necessary are evaluated again beside ghosts, which changes nothing
  const auto mark_beside_ghosts = [&](std::uint8_t with, const auto& is_source) {
    particles.share().for_each_ghost([&](std::size_t ghost) {
      if (is_source(ghost)) family.for_each_end_at_ghost(ghost, particles, [&](std::size_t i, std::size_t) { affected_[i / byte_lanes] |= with; });
    });
  };
  mark_families_of(of_strain, [&](std::size_t slot) { return is_stress_known(slot) && perimpact::equivalent_strain(tensor_at(increment_, slot)) > 0; });
  mark_beside_ghosts(of_strain, [&](std::size_t ghost) { return perimpact::equivalent_strain(tensor_at(increment_, ghost)) > 0; });
  if (!theta_.slots()) return;
  const std::vector<std::uint8_t> of_ghosts = particles.share().refreshed_flags(affected_);
  mark_families_of(of_dilatation,
                   [&](std::size_t slot) { return (std::atomic_ref(affected_[slot / byte_lanes]).load(std::memory_order_relaxed) & of_strain) != 0; });
  mark_beside_ghosts(of_dilatation, [&](std::size_t ghost) { return (of_ghosts[ghost] & of_strain) != 0; });
}

std::array<const double*, 14> PlasticForce::arrays_of_flow() const {
  std::array<const double*, 14> arrays;
  for (std::size_t c = 0; c < 6; ++c) arrays[c] = strain_.component(c), arrays[6 + c] = increment_.component(c);
  arrays[12] = pressure_slope_.component(0), arrays[13] = resistance_.component(0);
  return arrays;
}

void PlasticForce::set_plastic_strain(std::size_t slot, const SymmetricTensor& strain, const Family& family) {
  set(strain_, slot, strain);
  equivalent_.component(0)[slot] = perimpact::equivalent_strain(strain);
  mark(slot, family);
}

double PlasticForce::dissipation(Ranks& ranks) const { return perimpact::exact_sum(ranks, dissipation_); }

}  // namespace perimpact
