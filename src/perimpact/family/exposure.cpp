#include "perimpact/family/exposure.hpp"

#include <array>

#include "base/parallel.hpp"

namespace perimpact {

using fccda::byte_lanes;

namespace {

/// Bits 0 … 7 as bytes 0 … 7, each 0 or 1.
constexpr std::array<std::uint64_t, 256> spread_bits() {
  std::array<std::uint64_t, 256> spread{};
  for (std::size_t byte = 0; byte < 256; ++byte)
    for (std::size_t bit = 0; bit < 8; ++bit) spread[byte] |= static_cast<std::uint64_t>((byte >> bit) & 1u) << (8 * bit);
  return spread;
}
constexpr std::array<std::uint64_t, 256> spread = spread_bits();

}  // namespace

bool is_at_surface(const Particles& particles, std::size_t slot) {
  const Lattice* lattice = particles.lattice();
  if (!lattice) return true;
  const auto [i, j, k] = lattice->cell(slot);
  const auto is_filled = [&](int ni, int nj, int nk) { return lattice->contains(ni, nj, nk) && particles.is_occupied(lattice->slot(ni, nj, nk)); };
  const bool is_enclosed = is_filled(i - 1, j, k) && is_filled(i + 1, j, k) && is_filled(i, j - 1, k) && is_filled(i, j + 1, k);
  return !is_enclosed || !(particles.is_plane() || (is_filled(i, j, k - 1) && is_filled(i, j, k + 1)));
}

std::array<std::uint16_t, byte_lanes> count_bonds(const Family& family, std::size_t eight) {
  std::array<std::uint16_t, byte_lanes> counts{};
  constexpr std::size_t most = 255;  // maximum count in a byte
  const std::uint8_t* bytes = family.bytes(eight);
  const std::size_t rows = family.begin(eight + 1) - family.begin(eight);
  for (std::size_t begin = 0; begin < rows; begin += most) {
    std::uint64_t sums = 0;
    for (std::size_t row = begin; row < std::min(begin + most, rows); ++row) sums += spread[bytes[row]];
    for (std::size_t lane = 0; lane < byte_lanes; ++lane) counts[lane] = static_cast<std::uint16_t>(counts[lane] + ((sums >> (8 * lane)) & 0xff));
  }
  return counts;
}

Exposure::Exposure(const Particles& particles, const Family& family, std::span<const std::uint32_t> broken_ends)
    : marks_(particles.slots(), 0), first_bonds_(particles.slots(), 0), broken_ends_(broken_ends.begin(), broken_ends.end()) {
  fccda::parallel_for(static_cast<std::ptrdiff_t>(particles.slots() / byte_lanes), [&](std::ptrdiff_t e) {
    const std::size_t eight = static_cast<std::size_t>(e);
    const auto counts = count_bonds(family, eight);
    for (std::size_t lane = 0; lane < byte_lanes; ++lane) {
      const std::size_t slot = eight * byte_lanes + lane;
      first_bonds_[slot] = counts[lane];
      if (!particles.is_occupied(slot)) continue;
      if (is_at_surface(particles, slot)) marks_[slot] = surface;
      if (family.damage(slot) > 0) marks_[slot] = static_cast<std::uint8_t>(marks_[slot] | lost);
    }
  });
}

Exposure::Change Exposure::update(const Family& family, std::span<const std::uint32_t> broken_ends) {
  Change change;
  std::vector<std::uint32_t>& eights = change.eights;
  for (std::size_t eight = 0; eight < broken_ends.size(); ++eight)
    if (broken_ends[eight] != broken_ends_[eight]) eights.push_back(static_cast<std::uint32_t>(eight));
  std::vector<std::uint8_t> found(eights.size(), 0);  // bit l: slot l of the eight
  fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>(eights.size()), [&](std::ptrdiff_t e) {
    const std::size_t eight = eights[static_cast<std::size_t>(e)], first = eight * byte_lanes;
    broken_ends_[eight] = broken_ends[eight];
    const auto is_settled = [&](std::size_t slot) { return has_lost(slot) || first_bonds_[slot] == 0; };
    std::size_t lane = 0;
    while (lane < byte_lanes && is_settled(first + lane)) ++lane;
    if (lane == byte_lanes) return;
    const auto counts = count_bonds(family, eight);
    std::uint8_t& bits = found[static_cast<std::size_t>(e)];
    for (; lane < byte_lanes; ++lane) {
      const std::size_t slot = first + lane;
      if (has_lost(slot) || counts[lane] == first_bonds_[slot]) continue;
      marks_[slot] = static_cast<std::uint8_t>(marks_[slot] | lost);
      bits = static_cast<std::uint8_t>(bits | 1u << lane);
    }
  });
  for (std::size_t e = 0; e < eights.size(); ++e)
    fccda::for_each_bit(found[e], [&](std::size_t lane) { change.first_lost.push_back(static_cast<std::uint32_t>(eights[e] * byte_lanes + lane)); });
  return change;
}

}  // namespace perimpact
