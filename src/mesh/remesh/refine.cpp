#include "mesh/remesh/refine.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/contract.hpp"
#include "base/error.hpp"
#include "mesh/remesh/as_panels.hpp"
#include "mesh/remesh/bisection.hpp"
#include "mesh/remesh/curvature.hpp"
#include "mesh/remesh/target_size.hpp"

namespace fccda {
namespace {

/// The size that would do, rounded up to two digits.
double affordable_panel(Refinement refinement, const TargetSize& wanted, double most) {
  for (double count = wanted.estimated_panels(refinement); count > most; count = wanted.estimated_panels(refinement))
    refinement.edge_length *= std::clamp(std::sqrt(count / most), 1.1, 1e6);  // halvings of thin triangles do not go with the square
  const double digit = std::pow(10.0, std::floor(std::log10(refinement.edge_length)) - 1);
  return std::ceil(refinement.edge_length / digit) * digit;
}

void expect_affordable(std::span<const Refinement> refinements, const TargetSize& wanted, double most) {
  double total = 0, largest = 0;
  const Refinement* culprit = nullptr;
  for (const Refinement& refinement : refinements) {
    const double count = wanted.estimated_panels(refinement);
    total += count;
    if (count > largest) largest = count, culprit = &refinement;
  }
  if (!(total > most)) return;
  // what the others take is not to be had; half of it all is left to the largest where they take more
  const double left = std::max(most - (total - largest), 0.5 * most);
  std::ostringstream sentence;
  sentence.precision(2);
  sentence << culprit->name << ": panels of " << culprit->edge_length << " m would be about " << largest << " of them, more than the " << left
           << " that there is room for; panels of " << affordable_panel(*culprit, wanted, left) << " m would do.";
  throw InputError(sentence.str());
}

}  // namespace

Panels refine(const Surface& surface, std::span<const Refinement> refinements, double most) {
  for ([[maybe_unused]] const Refinement& refinement : refinements) EXPECTS(refinement.panel > 0 && refinement.angle.value_or(1) > 0);
  const Curvature curved = curvature(surface);
  const TargetSize wanted(surface, curved, refinements);
  expect_affordable(refinements, wanted, most);

  Bisection bisection(surface, curved.is_crease);
  // What is added at the end is looked at later; a piece that is small enough stays so when a neighbour has it halved.
  for (std::size_t p = 0; p < bisection.pieces().size(); ++p)
    while (bisection.longest_edge(bisection.pieces()[p]) > wanted.of(bisection, bisection.pieces()[p])) bisection.halve(p);

  Panels out = empty_panels(surface);
  out.vertices.assign(bisection.vertices().begin(), bisection.vertices().end());
  out.panels.reserve(bisection.pieces().size());
  for (const Bisection::Piece& piece : bisection.pieces()) add_triangle_like(surface, piece.given, piece.vertex, out);
  return out;
}

}  // namespace fccda
