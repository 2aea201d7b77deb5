/// Symplectic Euler (seed paper, section 4; Madenci and Oterkus 2014, ch. 7): v += f dt/ρ, then x += v dt. Second order, stable for ω dt < 2;
/// the velocities belong to the middle of the step.
#pragma once

#include <span>

#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Slots of which contact asks for one common bound on the way they went in the step.
inline constexpr std::size_t travel_block = 64;

/// Number of blocks that cover all slots.
inline std::size_t travel_blocks(const Particles& particles) { return (particles.slots() + travel_block - 1) / travel_block; }

/// Advances all particles by dt [s]; travel[b] becomes the longest way [m] that any particle of block b went.
void advance(Particles& particles, double dt, std::span<double> travel);

}  // namespace perimpact
