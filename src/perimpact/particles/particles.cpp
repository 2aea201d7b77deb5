#include "perimpact/particles/particles.hpp"

#include <algorithm>

namespace perimpact {

Particles::Particles(const Lattice& lattice, int reach, double density, const std::function<bool(const Vec3d&)>& inside)
    : lattice_(lattice), slack_(static_cast<std::size_t>(lattice.offset(reach, reach, reach)) + fccda::byte_lanes), density_(density) {
  const std::size_t slots = lattice_.slots();
  position = VectorArray(slots, slack_);
  velocity = VectorArray(slots, slack_);
  force_density = VectorArray(slots, slack_);
  occupied_.assign(slots / fccda::byte_lanes, 0);
  for (std::size_t slot = 0; slot < slots; ++slot) {
    position.set(slot, reference(slot));
    const auto [i, j, k] = lattice_.cell(slot);
    if (!lattice_.contains(i, j, k) || !inside(reference(slot))) continue;
    occupied_[slot / 8] = static_cast<std::uint8_t>(occupied_[slot / 8] | (1u << (slot % 8)));
    slot_of_.push_back(static_cast<std::uint32_t>(slot));
  }
}

void Particles::remove(std::span<const std::size_t> slots) {
  for (const std::size_t slot : slots) {
    occupied_[slot / 8] = static_cast<std::uint8_t>(occupied_[slot / 8] & ~(1u << (slot % 8)));
    velocity.set(slot, {});  // what slots without a particle hold
  }
  std::erase_if(slot_of_, [&](std::uint32_t slot) { return std::binary_search(slots.begin(), slots.end(), std::size_t{slot}); });
}

}  // namespace perimpact
