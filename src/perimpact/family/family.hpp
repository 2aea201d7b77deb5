/// Families of a body: the bonds of its particles, one bit per bond, stored at both ends and always equal there.
///
/// The bits of one bond of eight neighbouring slots form a byte, which is the mask of a pack in the kernel. On a lattice all particles share
/// one stencil and neighbours are not stored; for a point cloud the geometry is a bond list. Ghosts of other ranks have no bonds of their own.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "perimpact/family/bond_list.hpp"
#include "perimpact/family/stencil.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Bond of a particle, for set-up and evaluation.
struct FamilyBond {
  std::size_t index;  ///< of the bond in the stencil, or of the entry in the list
  std::size_t j;      ///< slot of the neighbour
  Vec3d direction;    ///< ξ/|ξ|
  double length;      ///< [m] |ξ|
  double volume;      ///< [m³] v V_j
};

/// Bits of all bonds, for visitors of state. `begin`: the first row of each eight and one past the last, where their number varies; else empty.
struct BytesOfBonds : std::span<std::uint8_t> {
  BytesOfBonds(std::span<std::uint8_t> bytes, std::span<const std::size_t> begin_of_eights) : std::span<std::uint8_t>(bytes), begin_of_eight(begin_of_eights) {}
  std::span<const std::size_t> begin_of_eight;
};

class Family {
 public:
  /// All bonds of the stencil between particles of the body, which are on a lattice.
  Family(Stencil stencil, const Particles& particles);
  /// The bonds of the list; `particles`: those of the list.
  Family(BondList list, const Particles& particles);

  const Stencil* stencil() const { return std::get_if<Stencil>(&geometry_); }            ///< null for a list
  const BondList* list() const { return std::get_if<BondList>(&geometry_); }             ///< null for a stencil
  double horizon() const { return stencil() ? stencil()->horizon() : list()->horizon; }  ///< [m] δ
  /// [m] Length that bonds do not exceed; two particles of this mean size [m] that are nearer have a bond initially.
  double reach(double size) const { return horizon() + (stencil() ? stencil()->beyond_horizon() : list()->beyond_horizon) * size; }
  std::span<const std::ptrdiff_t> offsets() const { return offsets_; }  ///< in slots, of each bond of the stencil

  /// Bonds of slots 8·eight … 8·eight + 7 are rows begin(eight) … begin(eight + 1) - 1 of all; a row has one byte.
  std::size_t begin(std::size_t eight) const { return stencil() ? eight * offsets_.size() : list()->begin[eight]; }
  std::uint8_t* bytes(std::size_t eight) { return bits_.data() + begin(eight); }
  const std::uint8_t* bytes(std::size_t eight) const { return bits_.data() + begin(eight); }

  /// True if slots 8·eight … 8·eight + 7 have all bonds of the stencil; false for a list.
  bool is_complete(std::size_t eight) const {
    if (!stencil()) return false;
    unsigned all = 0xff;  // without a branch in the loop, so that it is vectorised
    const std::uint8_t* row = bytes(eight);
    for (std::size_t r = 0; r < offsets_.size(); ++r) all &= row[r];
    return all == 0xff;
  }

  /// Row of a bond of this particle in those of its eight.
  std::size_t row_of(std::size_t slot, const FamilyBond& bond) const {
    return stencil() ? bond.index : bond.index / fccda::byte_lanes - begin(slot / fccda::byte_lanes);
  }

  /// Calls visit(FamilyBond) for all intact bonds of a particle, in the order of force summation. Visitors may break the bond that they visit.
  template <class Visit>
  void for_each_bond(std::size_t slot, const Visit& visit) const {
    const std::size_t eight = slot / fccda::byte_lanes, lane = slot % fccda::byte_lanes, first = begin(eight), rows = begin(eight + 1) - first;
    const std::uint8_t* const of_eight = bits_.data() + first;
    if (const Stencil* stencil = this->stencil()) {
      for (std::size_t r = 0; r < rows; ++r)
        if ((of_eight[r] >> lane) & 1u) visit(bond_of(*stencil, slot, r));
    } else {
      for (std::size_t r = 0; r < rows; ++r)
        if ((of_eight[r] >> lane) & 1u) visit(bond_of(*list(), slot, (first + r) * fccda::byte_lanes + lane));
    }
  }

  /// Calls visit(i, row) for each owned particle i whose bond to this ghost is bit i % 8 of the byte `row` of its eight, whether it is intact or not.
  template <class Visit>
  void for_each_end_at_ghost(std::size_t ghost, const Particles& particles, const Visit& visit) const {
    if (!stencil()) {
      for (auto end = std::ranges::lower_bound(ends_at_ghosts_, ghost, {}, &EndAtGhost::ghost); end != ends_at_ghosts_.end() && end->ghost == ghost; ++end)
        visit(std::size_t{end->slot}, std::size_t{end->row});
      return;
    }
    const Lattice& lattice = *particles.lattice();
    const std::vector<StencilBond>& bonds = stencil()->bonds();
    const std::array<int, 3> cell = lattice.cell(ghost);
    for (std::size_t row = 0; row < bonds.size(); ++row) {  // from the other end: its offset is the opposite
      const int i = cell[0] - bonds[row].di, j = cell[1] - bonds[row].dj, k = cell[2] - bonds[row].dk;
      if (!lattice.contains(i, j, k)) continue;
      if (const std::size_t slot = lattice.slot(i, j, k); particles.owns(slot)) visit(slot, row);
    }
  }

  /// Breaks the bonds for which is_cut(i, j): they count as damage, and corrections remain unchanged. Returns their number.
  template <class IsCut>
  std::size_t cut(const IsCut& is_cut) {
    std::size_t ends = 0;
    for (std::size_t i = 0; i < volumes_of_.size() * fccda::byte_lanes; ++i) {
      const std::size_t eight = i / fccda::byte_lanes, lane = i % fccda::byte_lanes, first = begin(eight), rows = begin(eight + 1) - first;
      for (std::size_t r = 0; r < rows; ++r) {
        std::uint8_t& byte = bits_[first + r];
        if (!((byte >> lane) & 1u)) continue;
        const FamilyBond bond = stencil() ? bond_of(*stencil(), i, r) : bond_of(*list(), i, (first + r) * fccda::byte_lanes + lane);
        if (!is_cut(i, bond.j)) continue;
        byte = static_cast<std::uint8_t>(byte & ~(1u << lane));
        ++ends;
      }
    }
    return ends / 2;
  }

  /// Breaks all bonds of a particle, which may be a ghost. Calls broke(slot) for each owned particle that loses one, also this one, once for each bond.
  template <class Broke>
  void isolate(std::size_t slot, const Particles& particles, const Broke& broke) {
    const auto clear = [&](std::size_t of, std::size_t row) {
      std::uint8_t& byte = bits_[begin(of / fccda::byte_lanes) + row];
      const auto bit = static_cast<std::uint8_t>(1u << (of % fccda::byte_lanes));
      if (!(byte & bit)) return;
      byte = static_cast<std::uint8_t>(byte & ~bit);
      broke(of);
    };
    if (!particles.owns(slot)) return for_each_end_at_ghost(slot, particles, clear);
    for_each_bond(slot, [&](const FamilyBond& bond) {
      clear(slot, row_of(slot, bond));
      if (!particles.owns(bond.j)) return;
      for_each_bond(bond.j, [&](const FamilyBond& back) {
        if (back.j == slot) clear(bond.j, row_of(bond.j, back));
      });
    });
  }

  std::size_t initial_bonds() const { return initial_bonds_; }  ///< of the body, each counted once
  /// Each counted once; with the share of its particles, of the whole body (collective).
  std::size_t intact_bonds(const Share& share = Share()) const;

  /// [m³] Σ v V over the initial family.
  double initial_volume(std::size_t slot) const {
    return initial_volumes_[volumes_of_[slot / fccda::byte_lanes] * fccda::byte_lanes + slot % fccda::byte_lanes];
  }
  double intact_volume(std::size_t slot) const;  ///< [m³] the same over intact bonds
  /// φ = 1 - Σ µ v V / Σ v V [-] (Silling and Askari 2005); 0 for a particle without initial bonds.
  double damage(std::size_t slot) const;

  double bytes() const;  ///< [bytes] of memory

  template <class Visitor>
  void visit_state(const std::string& name, Visitor&& visit) {
    visit(name + ".bonds", BytesOfBonds{bits_, list() ? std::span<const std::size_t>(list()->begin) : std::span<const std::size_t>()});
  }

 private:
  FamilyBond bond_of(const Stencil& stencil, std::size_t slot, std::size_t row) const {
    const StencilBond& bond = stencil.bonds()[row];
    return {row, static_cast<std::size_t>(static_cast<std::ptrdiff_t>(slot) + offsets_[row]), bond.direction, bond.length, bond.volume};
  }
  FamilyBond bond_of(const BondList& list, std::size_t slot, std::size_t entry) const {
    const auto j = static_cast<std::size_t>(list.neighbour[entry]);
    return {entry, j, (reference_[j] - reference_[slot]) / list.length[entry], list.length[entry], list.volume[entry]};
  }
  std::size_t intact_ends() const;  // of intact bonds at owned particles
  void find_ends_at_ghosts(const Particles& particles);
  void sum_initial_volumes();

  std::variant<Stencil, BondList> geometry_;
  std::vector<std::ptrdiff_t> offsets_;
  std::vector<Vec3d> reference_;  // [m] of a cloud
  struct EndAtGhost {
    std::uint32_t ghost, slot, row;  // row in those of the eight
  };
  std::vector<EndAtGhost> ends_at_ghosts_;  // of a cloud, ascending
  std::vector<std::uint8_t> bits_;
  std::vector<std::uint32_t> volumes_of_;  // of each eight slots, their place in initial_volumes_, in eights
  std::vector<double> initial_volumes_;    // [m³] those of complete families, of empty cells, and of eights with others
  std::size_t initial_bonds_ = 0;
};

}  // namespace perimpact
