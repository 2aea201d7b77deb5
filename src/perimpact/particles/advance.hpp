/// Symplectic Euler (leapfrog, equivalent to velocity Verlet; Zhang et al., section 4; Madenci and Oterkus 2014, ch. 7): v += f dt/ρ, then
/// x += v dt. Second order, stable for ω dt < 2; velocities are at the middle of the step.
#pragma once

#include <span>

#include "perimpact/particles/advance_kernels.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Number of slots with a common bound on the distance travelled in the step, for contact search.
inline constexpr std::size_t travel_block = 64;

/// Number of blocks that cover all slots.
inline std::size_t travel_blocks(const Particles& particles) { return (particles.slots() + travel_block - 1) / travel_block; }

/// What a step of dt [s] reads and writes.
Motion motion_of(Particles& particles, double dt);

/// Advances all particles by dt [s]; travel[b] becomes the largest distance [m] travelled by a particle of block b.
void advance(Particles& particles, double dt, std::span<double> travel);

}  // namespace perimpact
