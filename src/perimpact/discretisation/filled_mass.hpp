/// Mass of the particles of a body against that of its solid.
#pragma once

namespace perimpact {

/// Mass of the particles relative to their solid.
struct FilledMass {
  double solid;      ///< [kg]
  double particles;  ///< [kg] before any were removed

  double excess() const { return particles / solid - 1; }  ///< [-] relative excess of the particles
};

}  // namespace perimpact
