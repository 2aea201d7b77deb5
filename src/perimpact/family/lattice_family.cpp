#include "perimpact/family/lattice_family.hpp"

#include <bit>

#include "fccda/core/parallel.hpp"

namespace perimpact {

namespace {
std::size_t count_bits(const std::vector<std::uint8_t>& bytes) {
  std::size_t count = 0;
  for (const std::uint8_t byte : bytes) count += static_cast<std::size_t>(std::popcount(byte));
  return count;
}
}  // namespace

LatticeFamily::LatticeFamily(Stencil stencil, const Particles& particles) : stencil_(std::move(stencil)) {
  const Lattice& lattice = particles.lattice();
  for (const StencilBond& bond : stencil_.bonds()) offsets_.push_back(lattice.offset(bond.di, bond.dj, bond.dk));
  bits_.assign(lattice.slots() / fccda::byte_lanes * stencil_.size(), 0);
  initial_volume_.assign(lattice.slots(), 0);

  fccda::parallel_for(static_cast<std::ptrdiff_t>(lattice.slots() / fccda::byte_lanes), [&](std::ptrdiff_t eight) {
    for (std::size_t lane = 0; lane < fccda::byte_lanes; ++lane) {
      const std::size_t slot = static_cast<std::size_t>(eight) * fccda::byte_lanes + lane;
      if (!particles.is_occupied(slot)) continue;
      const auto [i, j, k] = lattice.cell(slot);
      for (std::size_t b = 0; b < stencil_.size(); ++b) {
        const StencilBond& bond = stencil_.bonds()[b];
        if (!lattice.contains(i + bond.di, j + bond.dj, k + bond.dk)) continue;
        if (!particles.is_occupied(lattice.slot(i + bond.di, j + bond.dj, k + bond.dk))) continue;
        std::uint8_t& byte = bytes(static_cast<std::size_t>(eight))[b];
        byte = static_cast<std::uint8_t>(byte | (1u << lane));
      }
      initial_volume_[slot] = intact_volume(slot);
    }
  });
  initial_bonds_ = count_bits(bits_) / 2;
}

std::size_t LatticeFamily::intact_bonds() const { return count_bits(bits_) / 2; }

double LatticeFamily::intact_volume(std::size_t slot) const {
  double sum = 0;
  for (std::size_t b = 0; b < stencil_.size(); ++b)
    if (is_intact(slot, b)) sum += stencil_.bonds()[b].volume;
  return sum;
}

double LatticeFamily::damage(std::size_t slot) const {
  const double initial = initial_volume_[slot];
  return initial > 0 ? 1 - intact_volume(slot) / initial : 0;
}

}  // namespace perimpact
