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

/// An affordable size, rounded up to two digits.
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
  // The share of the others is unavailable; if they take more than half, half of it all is left to the largest.
  const double left = std::max(most - (total - largest), 0.5 * most);
  std::ostringstream sentence;
  sentence.precision(2);
  sentence << culprit->name << ": an edge length of " << culprit->edge_length << " m would give about " << largest << " panels, more than the limit of " << left
           << "; use " << affordable_panel(*culprit, wanted, left) << " m or more.";
  throw InputError(sentence.str());
}

}  // namespace

Panels refine(const Surface& surface, std::span<const Refinement> refinements, double most) {
  for ([[maybe_unused]] const Refinement& refinement : refinements) EXPECTS(refinement.edge_length > 0 && refinement.angle.value_or(1) > 0);
  const Curvature curved = curvature(surface);
  const TargetSize wanted(surface, curved, refinements);
  expect_affordable(refinements, wanted, most);

  Bisection bisection(surface, curved.is_crease);
  // Appended pieces are visited later; a piece that is small enough stays so when a neighbour has it halved.
  for (std::size_t p = 0; p < bisection.pieces().size(); ++p)
    while (bisection.longest_edge(bisection.pieces()[p]) > wanted.of(bisection, bisection.pieces()[p])) bisection.halve(p);

  Panels out = empty_panels(surface);
  out.vertices.assign(bisection.vertices().begin(), bisection.vertices().end());
  out.panels.reserve(bisection.pieces().size());
  for (const Bisection::Piece& piece : bisection.pieces()) add_triangle_like(surface, piece.given, piece.vertex, out);
  return out;
}

}  // namespace fccda
