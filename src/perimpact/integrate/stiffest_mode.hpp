/// The highest frequency of a body as it is: its own particles, surfaces, cracks and material.
#pragma once

#include <vector>

#include "perimpact/body/body.hpp"

namespace perimpact {

/// ω² [1/s²] of the stiffest mode of small displacements about the reference positions, with the bonds that the body has now. Found by Lanczos'
/// method (Golub and Van Loan, Matrix Computations, ch. 10) from a seeded random start; the product with the stiffness is one evaluation of
/// the body's own forces, on a copy of it, in which no bond breaks. Held particles are taken as free, which errs on the safe side.
///
/// `products` evaluations are made, and three fields of displacements are kept. The result never exceeds ω²; with 40 it is below by 0.1 % for
/// plates of 19 000 and 145 000 particles (with 20, by 0.7 %). 0 where the body has no bonds.
double stiffest_mode(const Body& body, int products = 40);

/// The same where its particles had these densities [kg/m³], one of each slot.
double stiffest_mode(const Body& body, std::vector<double> densities, int products = 40);

}  // namespace perimpact
