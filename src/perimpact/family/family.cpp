#include "perimpact/family/family.hpp"

#include <algorithm>
#include <bit>
#include <tuple>
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

Family::Family(Stencil stencil, const Particles& particles) : geometry_(std::move(stencil)), volumes_of_(particles.slots() / byte_lanes, 0) {
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
      if (own == 0 || !particles.is_owned_eight(row * eights + e)) continue;
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
  initial_bonds_ = intact_bonds(particles.share());
}

Family::Family(BondList list, const Particles& particles) : geometry_(std::move(list)), volumes_of_(particles.slots() / byte_lanes, 0) {
  bits_ = std::move(std::get<BondList>(geometry_).bits);
  reference_.reserve(particles.slots());
  for (std::size_t slot = 0; slot < particles.slots(); ++slot) reference_.push_back(particles.reference(slot));
  find_ends_at_ghosts(particles);
  sum_initial_volumes();
  initial_bonds_ = intact_bonds(particles.share());
}

void Family::find_ends_at_ghosts(const Particles& particles) {
  if (particles.share().is_whole()) return;
  for (const std::uint32_t slot : particles.slot_of()) {
    const std::size_t first = begin(slot / byte_lanes);
    for_each_bond(slot, [&](const FamilyBond& bond) {
      if (particles.owns(bond.j)) return;
      ends_at_ghosts_.push_back({static_cast<std::uint32_t>(bond.j), slot, static_cast<std::uint32_t>(bond.index / byte_lanes - first)});
    });
  }
  std::ranges::sort(ends_at_ghosts_, {}, [](const EndAtGhost& end) { return std::tuple(end.ghost, end.slot, end.row); });
}

void Family::sum_initial_volumes() {
  double whole = 0;  // of a complete family, in the order of intact_volume()
  if (stencil())
    for (const StencilBond& bond : stencil()->bonds()) whole += bond.volume;
  constexpr std::uint32_t complete = 0, empty = 1;
  std::uint32_t others = empty;
  for (std::size_t eight = 0; eight < volumes_of_.size(); ++eight) {
    const std::uint8_t* rows = bytes(eight);
    const bool is_empty = std::all_of(rows, rows + (begin(eight + 1) - begin(eight)), [](std::uint8_t row) { return row == 0; });
    volumes_of_[eight] = is_complete(eight) ? complete : is_empty ? empty : ++others;
  }
  initial_volumes_.assign((others + std::size_t{1}) * byte_lanes, 0);
  std::fill_n(initial_volumes_.begin(), byte_lanes, whole);
  fccda::parallel_for(static_cast<std::ptrdiff_t>(volumes_of_.size()), [&](std::ptrdiff_t number) {
    const auto eight = static_cast<std::size_t>(number);
    if (volumes_of_[eight] <= empty) return;
    for (std::size_t lane = 0; lane < byte_lanes; ++lane) initial_volumes_[volumes_of_[eight] * byte_lanes + lane] = intact_volume(eight * byte_lanes + lane);
  });
}

std::size_t Family::intact_bonds(const Share& share) const { return static_cast<std::size_t>(share.ranks().sum(static_cast<std::int64_t>(intact_ends()))) / 2; }

std::size_t Family::intact_ends() const {
  std::size_t ends = 0;
  for (const std::uint8_t byte : bits_) ends += static_cast<std::size_t>(std::popcount(byte));
  return ends;
}

double Family::intact_volume(std::size_t slot) const {
  const std::size_t eight = slot / byte_lanes, lane = slot % byte_lanes, first = begin(eight), rows = begin(eight + 1) - first;
  double sum = 0;
  for (std::size_t r = 0; r < rows; ++r)
    if ((bits_[first + r] >> lane) & 1u) sum += stencil() ? stencil()->bonds()[r].volume : list()->volume[(first + r) * byte_lanes + lane];
  return sum;
}

double Family::damage(std::size_t slot) const {
  const double initial = initial_volume(slot);
  return initial > 0 ? 1 - intact_volume(slot) / initial : 0;
}

double Family::bytes() const {
  const std::size_t slots = volumes_of_.size() * byte_lanes;
  const std::size_t of_list = list() ? list()->neighbour.size() * (sizeof(std::int32_t) + 2 * sizeof(double)) + slots * sizeof(Vec3d) : 0;
  return static_cast<double>(bits_.size() + volumes_of_.size() * sizeof(std::uint32_t) + initial_volumes_.size() * sizeof(double) + of_list);
}

}  // namespace perimpact
