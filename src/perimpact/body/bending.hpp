/// Bending stiffness of a plate of few particle layers. Thin lattices lack bonds that a thick body has; the surface correction compensates this
/// in stretching, not in bending: four layers have 0.8 of the stiffness of a plate, and thin ice sheets seldom have more layers.
///
/// The model is the lattice, law and surface correction of the body, in a plate so wide that its edge does not affect its middle, bent to a
/// cylinder of curvature κ about the middle plane ζ = 0:
///   u_x = κ x ζ,  u_ζ = -κ x²/2 + c_k,
/// with the bulges c_k of the layers that minimise the energy. Since all columns are equivalent, there are no other unknowns. The energy of a
/// column is ½ D κ² times its area. A 2-D body bends in its plane.
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
  std::optional<double> thickness;  ///< [m] in z of a 2-D body
  std::size_t axis;
  int layers;
};

/// Bending stiffness D of such layers over that of a plate of the same thickness, E h³/12/(1 - ν²); of a 2-D body, E h³/12 with the 2-D modulus.
/// 1 is exact; 0 means no resistance to bending.
double relative_bending_stiffness(const ThinLattice& plate, const OrdinaryState& law, CorrectionKind correction, const Stencil& stencil);

}  // namespace perimpact
