#include "perimpact/family/family.hpp"

#include <bit>
#include <utility>

#include "base/parallel.hpp"

namespace perimpact {

using fccda::byte_lanes;

namespace {

/// Bits of the occupied cells among eight cells of a row from `column` on; there are none beyond the ends of the row, which has `eights` from `first` on.
unsigned occupied_from(const Particles& particles, std::size_t first, std::ptrdiff_t eights, std::ptrdiff_t column) {
  const auto bits_of = [&](std::ptrdiff_t eight) -> unsigned {
    return eight >= 0 && eight < eights ? particles.occupied(first + static_cast<std::size_t>(eight)) : 0u;
  };
  const std::ptrdiff_t eight = column >> 3;  // rounds down, also below 0
  return ((bits_of(eight) | bits_of(eight + 1) << 8) >> (column & 7)) & 0xffu;
}

}  // namespace

Family::Family(Stencil stencil, const Particles& particles) : geometry_(std::move(stencil)), initial_volume_(particles.slots(), 0) {
  EXPECTS(particles.lattice());
  const Lattice& lattice = *particles.lattice();
  const std::vector<StencilBond>& bonds = this->stencil()->bonds();
  for (const StencilBond& bond : bonds) offsets_.push_back(lattice.offset(bond.di, bond.dj, bond.dk));
  bits_.assign(lattice.slots() / byte_lanes * bonds.size(), 0);

  const std::size_t eights = lattice.row_slots() / byte_lanes;
  fccda::parallel_for(static_cast<std::ptrdiff_t>(lattice.rows()), [&](std::ptrdiff_t number) {
    const std::size_t row = static_cast<std::size_t>(number);
    const std::array<int, 3> cell = lattice.cell(row * lattice.row_slots());
    for (std::size_t e = 0; e < eights; ++e) {
      const unsigned own = particles.occupied(row * eights + e);
      if (own == 0) continue;
      std::uint8_t* of_eight = bytes(row * eights + e);
      for (std::size_t b = 0; b < bonds.size(); ++b) {
        const StencilBond& bond = bonds[b];
        const int j = cell[1] + bond.dj, k = cell[2] + bond.dk;
        if (!lattice.contains(0, j, k)) continue;
        const std::size_t first = lattice.slot(0, j, k) / byte_lanes;
        const auto column = static_cast<std::ptrdiff_t>(e * byte_lanes) + bond.di;
        of_eight[b] = static_cast<std::uint8_t>(own & occupied_from(particles, first, static_cast<std::ptrdiff_t>(eights), column));
      }
    }
  });
  sum_initial_volumes();
}

Family::Family(BondList list, const Particles& particles) : geometry_(std::move(list)), initial_volume_(particles.slots(), 0) {
  bits_ = std::move(std::get<BondList>(geometry_).bits);
  reference_.reserve(particles.slots());
  for (std::size_t slot = 0; slot < particles.slots(); ++slot) reference_.push_back(particles.reference(slot));
  sum_initial_volumes();
}

void Family::sum_initial_volumes() {
  double whole = 0;  // of a complete family, in the order of intact_volume()
  if (stencil())
    for (const StencilBond& bond : stencil()->bonds()) whole += bond.volume;
  fccda::parallel_for(static_cast<std::ptrdiff_t>(initial_volume_.size() / byte_lanes), [&](std::ptrdiff_t number) {
    const auto eight = static_cast<std::size_t>(number);
    const bool all_complete = is_complete(eight);
    for (std::size_t slot = eight * byte_lanes; slot < (eight + 1) * byte_lanes; ++slot) initial_volume_[slot] = all_complete ? whole : intact_volume(slot);
  });
  initial_bonds_ = intact_bonds();
}

std::size_t Family::intact_bonds() const {
  std::size_t ends = 0;
  for (const std::uint8_t byte : bits_) ends += static_cast<std::size_t>(std::popcount(byte));
  return ends / 2;
}

double Family::intact_volume(std::size_t slot) const {
  const std::size_t eight = slot / byte_lanes, lane = slot % byte_lanes, first = begin(eight), rows = begin(eight + 1) - first;
  double sum = 0;
  for (std::size_t r = 0; r < rows; ++r)
    if ((bits_[first + r] >> lane) & 1u) sum += stencil() ? stencil()->bonds()[r].volume : list()->volume[(first + r) * byte_lanes + lane];
  return sum;
}

double Family::damage(std::size_t slot) const {
  const double initial = initial_volume_[slot];
  return initial > 0 ? 1 - intact_volume(slot) / initial : 0;
}

double Family::bytes() const {
  const std::size_t slots = initial_volume_.size();
  const std::size_t of_list = list() ? list()->neighbour.size() * (sizeof(std::int32_t) + 2 * sizeof(double)) + slots * sizeof(Vec3d) : 0;
  return static_cast<double>(bits_.size() + slots * sizeof(double) + of_list);
}

}  // namespace perimpact
