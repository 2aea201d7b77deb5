/// Exposed particles of a body, which can come into contact: those at its surface, and those that have lost a bond. A particle with all its
/// nearest neighbours and all its bonds is enclosed by them.
///
/// On a lattice a particle is at the surface if one of its nearest cells (six, in 2-D four) is empty; in a point cloud every particle counts.
/// Both follow from positions and bonds, so that they are not part of the state.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "perimpact/family/family.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

class Exposure {
 public:
  /// `broken_ends`: cumulative, of each eight (InternalForce::broken_ends).
  Exposure(const Particles& particles, const Family& family, std::span<const std::uint32_t> broken_ends);

  /// What has broken since the last update.
  struct Change {
    std::vector<std::uint32_t> eights;      ///< with broken bonds, ascending
    std::vector<std::uint32_t> first_lost;  ///< slots of particles that lost their first bond, ascending
  };
  Change update(const Family& family, std::span<const std::uint32_t> broken_ends);

  bool is_exposed(std::size_t slot) const { return marks_[slot] != 0; }
  bool has_lost(std::size_t slot) const { return (marks_[slot] & lost) != 0; }  ///< lost a bond

 private:
  static constexpr std::uint8_t surface = 1, lost = 2;

  std::vector<std::uint8_t> marks_;         // of each slot
  std::vector<std::uint16_t> first_bonds_;  // of each slot
  std::vector<std::uint32_t> broken_ends_;  // of each eight, at the last update
};

/// True if the particle in this slot is at the surface, whatever its bonds.
bool is_at_surface(const Particles& particles, std::size_t slot);

/// Number of intact bonds of each of the slots 8·eight … 8·eight + 7.
std::array<std::uint16_t, fccda::byte_lanes> count_bonds(const Family& family, std::size_t eight);

}  // namespace perimpact
