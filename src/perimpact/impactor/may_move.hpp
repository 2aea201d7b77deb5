/// Whether an impactor moves, or may be moved by contact, in a degree of freedom.
#pragma once

#include <algorithm>
#include <cstddef>

#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

/// `degree`: index in degree_words. True if it has a velocity or a prescribed motion there, or is free.
inline bool may_move(const ImpactorSetup& setup, const Impactor& impactor, std::size_t degree) {
  const double velocity = degree < 3 ? impactor.fastest_velocity()[degree] : impactor.fastest_angular_velocity()[degree - 3];
  return velocity != 0 || setup.motion.of(degree) || std::ranges::find(setup.free_dofs, degree_words[degree]) != setup.free_dofs.end();
}

}  // namespace perimpact
