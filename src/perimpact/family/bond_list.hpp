/// Bond list of a point cloud, sliced in packs of eight particles.
///
/// The lists of eight neighbouring slots are padded to the longest; row r contains bond r of each of the eight, if it exists, so that a pack
/// loads neighbours, lengths and volumes as contiguous lanes. Bonds of a particle are sorted by the neighbour's slot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/aligned.hpp"
#include "base/pack.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

struct BondList {
  double horizon{};                                    ///< [m] δ
  double beyond_horizon{};                             ///< [-] by which bonds may exceed the horizon, over the mean size of both particles
  std::vector<std::size_t> begin;                      ///< first row of each pack of eight slots, and one past the last
  std::vector<std::uint8_t> bits;                      ///< of each row: bit l is set if slot l of the pack has this bond; moved to the Family
  fccda::UninitialisedVector<std::int32_t> neighbour;  ///< slots, eight per row; the particle itself without a bond
  fccda::UninitialisedVector<double> length;           ///< [m] |ξ|; 1 without a bond
  fccda::UninitialisedVector<double> volume;           ///< [m³] v V_j; 0 without a bond

  std::size_t rows() const { return begin.back(); }
};

/// Bond search for a point cloud. With Δ_i the edge of a cube of the particle's volume and Δ = (Δ_i + Δ_j)/2, the volume correction and reach
/// are those of the lattice (family/stencil.hpp): v = (δ + Δ/2 - |ξ|)/Δ, at most 1, up to δ + Δ/2 or, after Madenci and Oterkus, up to δ.
/// v is thus equal at both ends, and momentum is conserved exactly.
BondList find_bonds(FamilyRule rule, double horizon, const Particles& particles);

}  // namespace perimpact
