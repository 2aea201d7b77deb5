#include "perimpact/family/family.hpp"

#include <bit>

#include "base/parallel.hpp"

namespace perimpact {

using fccda::byte_lanes;

Family::Family(Stencil stencil, const Particles& particles) : geometry_(std::move(stencil)) {
  EXPECTS(particles.lattice());
  const Lattice& lattice = *particles.lattice();
  const std::vector<StencilBond>& bonds = this->stencil()->bonds();
  for (const StencilBond& bond : bonds) offsets_.push_back(lattice.offset(bond.di, bond.dj, bond.dk));
  bits_.assign(lattice.slots() / byte_lanes * bonds.size(), 0);

  fccda::parallel_for(static_cast<std::ptrdiff_t>(lattice.slots() / byte_lanes), [&](std::ptrdiff_t eight) {
    std::uint8_t* row = bytes(static_cast<std::size_t>(eight));
    for (std::size_t lane = 0; lane < byte_lanes; ++lane) {
      const std::size_t slot = static_cast<std::size_t>(eight) * byte_lanes + lane;
      if (!particles.is_occupied(slot)) continue;
      const auto [i, j, k] = lattice.cell(slot);
      for (std::size_t b = 0; b < bonds.size(); ++b) {
        const StencilBond& bond = bonds[b];
        if (!lattice.contains(i + bond.di, j + bond.dj, k + bond.dk)) continue;
        if (!particles.is_occupied(lattice.slot(i + bond.di, j + bond.dj, k + bond.dk))) continue;
        row[b] = static_cast<std::uint8_t>(row[b] | (1u << lane));
      }
    }
  });
  finish(particles);
}

Family::Family(BondList list, const Particles& particles) : geometry_(std::move(list)) {
  bits_ = this->list()->bits;
  for (std::size_t slot = 0; slot < particles.slots(); ++slot) reference_.push_back(particles.reference(slot));
  finish(particles);
}

void Family::finish(const Particles& particles) {
  slot_of_.assign(particles.slot_of().begin(), particles.slot_of().end());
  initial_volume_.assign(particles.slots(), 0);
  fccda::parallel_for(static_cast<std::ptrdiff_t>(slot_of_.size()), [&](std::ptrdiff_t particle) {
    const std::size_t slot = slot_of_[static_cast<std::size_t>(particle)];
    initial_volume_[slot] = intact_volume(slot);
  });
  initial_bonds_ = intact_bonds();
}

FamilyBond Family::bond(std::size_t slot, std::size_t first_row, std::size_t row) const {
  if (const Stencil* stencil = this->stencil()) {
    const StencilBond& bond = stencil->bonds()[row];
    return {row, static_cast<std::size_t>(static_cast<std::ptrdiff_t>(slot) + offsets_[row]), bond.direction, bond.length, bond.volume};
  }
  const BondList& list = *this->list();
  const std::size_t entry = (first_row + row) * byte_lanes + slot % byte_lanes, j = static_cast<std::size_t>(list.neighbour[entry]);
  return {entry, j, (reference_[j] - reference_[slot]) / list.length[entry], list.length[entry], list.volume[entry]};
}

std::size_t Family::intact_bonds() const {
  std::size_t ends = 0;
  for (const std::uint8_t byte : bits_) ends += static_cast<std::size_t>(std::popcount(byte));
  return ends / 2;
}

double Family::intact_volume(std::size_t slot) const {
  double sum = 0;
  for_each_bond(slot, [&](const FamilyBond& bond) { sum += bond.volume; });
  return sum;
}

double Family::damage(std::size_t slot) const {
  const double initial = initial_volume_[slot];
  return initial > 0 ? 1 - intact_volume(slot) / initial : 0;
}

double Family::bytes() const {
  const std::size_t slots = initial_volume_.size();
  const std::size_t of_list = list() ? list()->neighbour.size() * (sizeof(std::int32_t) + 2 * sizeof(double)) + list()->bits.size() + slots * sizeof(Vec3d) : 0;
  return static_cast<double>(bits_.size() + slots * sizeof(double) + slot_of_.size() * sizeof(std::uint32_t) + of_list);
}

}  // namespace perimpact
