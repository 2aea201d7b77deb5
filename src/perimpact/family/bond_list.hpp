/// The bonds of a body whose particles lie anywhere: a list for each particle, eight particles side by side.
///
/// The lists of eight neighbouring slots are as long as the longest of them; row r holds bond r of each of the eight, where it has one
/// (sliced rows), so that a pack loads neighbours, lengths and volumes as contiguous lanes. Bonds of a particle are in the order of its
/// neighbours' slots.
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
  double horizon{};                              ///< [m] δ
  std::vector<std::size_t> begin;                ///< first row of each eight slots, and one past the last
  std::vector<std::uint8_t> bits;                ///< of each row: bit l is set where slot l of the eight has this bond
  fccda::AlignedVector<std::int32_t> neighbour;  ///< slot, eight a row; where there is no bond, that of the particle itself
  fccda::AlignedVector<double> length;           ///< [m] |ξ|; 1 where there is no bond
  fccda::AlignedVector<double> volume;           ///< [m³] v V_j; 0 where there is no bond

  std::size_t rows() const { return bits.size(); }
};

/// The bonds of particles that lie anywhere. With Δ_i the edge of a cube of the particle's volume and Δ = (Δ_i + Δ_j)/2, partial volumes and
/// the reach are those of the lattice (family/stencil.hpp): v = (δ + Δ/2 - |ξ|)/Δ, at most 1, up to δ + Δ/2 or, after Madenci and
/// Oterkus, up to δ. So v is the same at both ends, and momentum is exact.
BondList find_bonds(FamilyRule rule, double horizon, const Particles& particles);

}  // namespace perimpact
