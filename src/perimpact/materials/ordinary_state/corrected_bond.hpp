/// Linear response of a bond of an ordinary state-based body, with the surface effect correction: for bounds of the time step.
#pragma once

#include "perimpact/family/family.hpp"
#include "perimpact/family/surface_correction.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state.hpp"

namespace perimpact {

/// [N/m⁷] derivative of the bond's force density with respect to its length, without the dilatation term.
inline double corrected_stiffness(const OrdinaryState& law, const CorrectionFactors& correction, std::size_t slot, const FamilyBond& bond) {
  return law.bond_stiffness(bond.length) * correction.stretch_factor(slot, bond.j, interpolation_weights(bond.direction));
}

/// [1/m⁴] derivative of the sum θ of the particle with respect to the bond's length, per unit volume of the bond.
inline double corrected_dilatation_slope(const OrdinaryState& law, const CorrectionFactors& correction, std::size_t slot, const FamilyBond& bond) {
  return law.d() * law.weights(bond.length).dilatation / bond.length * correction.dilatation_factor(slot, bond.j, interpolation_weights(bond.direction));
}

}  // namespace perimpact
