/// View of a body for the short-range force.
#pragma once

#include <limits>
#include <span>

#include "perimpact/family/family.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

struct ContactingBody {
  Particles& particles;
  const Family& family;
  std::span<const std::uint32_t> broken_ends;                         ///< broken bond ends of each eight so far
  double stiffness;                                                   ///< [N/m⁷] k of its springs (ShortRangeLaw::stiffness)
  double largest_pressure = std::numeric_limits<double>::infinity();  ///< [Pa] between its own fragments; beyond it they are compacted
};

}  // namespace perimpact
