/// How stiff a plate of few layers is in bending. Layers of particles miss bonds that a deep body has; the surface correction makes up for
/// stretching, not for bending: four layers have 0.8 of the stiffness of a plate, and thin sheets of ice are seldom given more.
///
/// Taken is the body's own lattice, law and surface correction, in a plate so wide that its middle does not know of the rim, bent to a cylinder
/// of curvature κ about the middle plane ζ = 0:
///   u_x = κ x ζ,  u_ζ = -κ x²/2 + c_k,
/// with the bulge c_k of each layer for which energy is least. A state that looks the same from every column has no other unknowns. The
/// energy of a column is ½ D κ² times its area; of a plane body the bending is in its plane.
#pragma once

#include <cstddef>

#include "perimpact/family/stencil.hpp"
#include "perimpact/family/surface_correction.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state.hpp"
#include "perimpact/particles/lattice.hpp"

namespace perimpact {

/// A lattice that is `layers` cells thick along an axis and wide in the other directions.
struct ThinLattice {
  double spacing;                   ///< [m]
  std::optional<double> thickness;  ///< [m] in z of a plane body
  std::size_t axis;
  int layers;
};

/// D of such layers over that of a plate as thick, E h³/12/(1 - ν²); of a plane body, E h³/12 with the modulus of the plane. 1 where it is right, 0
/// where the layers cannot resist bending.
double relative_bending_stiffness(const ThinLattice& plate, const OrdinaryState& law, CorrectionKind correction, const Stencil& stencil);

}  // namespace perimpact
