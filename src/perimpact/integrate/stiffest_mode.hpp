/// Highest frequency (stiffest mode) of a body with its particles, surfaces, cracks and material.
#pragma once

#include <vector>

#include "perimpact/body/body.hpp"

namespace perimpact {

/// ω² [1/s²] of the stiffest mode of small displacements about the reference positions, with the intact bonds. Computed by Lanczos'
/// method (Golub and Van Loan, Matrix Computations, ch. 10) from a seeded random start; the product with the stiffness is one force
/// evaluation on a copy of the body without bond failure. Constraints are ignored, which is conservative.
///
/// Needs `products` evaluations and three displacement fields. The result never exceeds ω²; with 40 it is 0.1 % below for plates of 19 000
/// and 145 000 particles (with 20, 0.7 %). 0 without bonds.
double stiffest_mode(const Body& body, int products = 40);

/// The same with these densities [kg/m³] per slot.
double stiffest_mode(const Body& body, std::vector<double> densities, int products = 40);

}  // namespace perimpact
