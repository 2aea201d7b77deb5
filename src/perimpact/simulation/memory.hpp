/// Memory estimate of a set-up before allocation, because the operating system overcommits memory and ends the program without a message.
#pragma once

#include <span>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/discretise.hpp"

namespace perimpact {

double physical_memory();  ///< [bytes] of this machine

/// [bytes] Peak memory of a run, summed over arrays, without surfaces and without the report, which is written after the rest is released.
struct Memory {
  double at_rest = 0;     ///< during steps
  double setting_up = 0;  ///< largest addition during set-up of bodies
  double pictures = 0;    ///< largest addition while an output frame is written
  double rubble = 0;      ///< addition with `contact.fragments` if all bonds have broken, in rubble as dense as the solid

  double peak() const;  ///< without rubble
};

/// `bodies`: discretisation of each. The bonds of a point cloud are estimated from a sample of its particles.
Memory memory_of(const Setup& setup, std::span<const Discretisation> bodies);

/// Throws SetupError, with the key of the largest body, if the peak exceeds `available` [bytes].
void expect_to_fit(const Setup& setup, std::span<const Discretisation> bodies, double available);

}  // namespace perimpact
