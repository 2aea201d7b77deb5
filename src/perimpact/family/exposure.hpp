/// Which particles of a body others may run into: those at its surface, and those that have lost a bond. A particle with all its nearest
/// neighbours and all its bonds is walled in by them.
///
/// On a lattice the surface is where one of the nearest cells (six, in the plane four) holds no particle; in a cloud every particle counts.
/// Both follow from points and bonds alone, so that they are no state of their own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "perimpact/family/family.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

class Exposure {
 public:
  /// `broken_ends`: so far, of each row (InternalForce::broken_ends).
  Exposure(const Particles& particles, const Family& family, std::span<const std::size_t> broken_ends);

  /// Looks again where rows have broken bonds since the last time. Returns the particles that had lost none by then, by slot.
  std::vector<std::uint32_t> update(const Particles& particles, const Family& family, std::span<const std::size_t> broken_ends);

  bool is_exposed(std::size_t slot) const { return marks_[slot] != 0; }
  bool has_lost(std::size_t slot) const { return (marks_[slot] & lost) != 0; }  ///< a bond it once had

 private:
  static constexpr std::uint8_t surface = 1, lost = 2;

  std::vector<std::uint8_t> marks_;         // of each slot
  std::vector<std::uint16_t> first_bonds_;  // of each slot
  std::vector<std::size_t> broken_ends_;    // of each row, when it was last looked at
};

/// How many intact bonds each of the slots 8·eight … 8·eight + 7 has.
std::array<std::uint16_t, fccda::byte_lanes> count_bonds(const Family& family, std::size_t eight);

}  // namespace perimpact
