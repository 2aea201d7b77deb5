#include "perimpact/impactor/remeshed.hpp"

#include <limits>
#include <utility>
#include <vector>

#include "mesh/inspect/self_intersections.hpp"
#include "mesh/remesh/coarsen.hpp"
#include "mesh/remesh/refine.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

namespace {

using fccda::Surface;

fccda::Refinement refinement_of(const RefinementSetup& setup) {
  fccda::Refinement refinement{.name = setup.name, .edge_length = setup.edge_length, .angle = setup.angle};
  if (setup.box) refinement.box = fccda::Box{setup.box->centre - 0.5 * setup.box->size, setup.box->centre + 0.5 * setup.box->size};
  if (!setup.surface_part.empty()) refinement.surface_part = setup.surface_part;
  return refinement;
}

/// Remeshed panels are already oriented outward.
Surface surface_of(const fccda::Panels& panels, const std::string& name) { return Surface(panels, {.orientation = fccda::Orientation::normals, .name = name}); }

}  // namespace

Remeshed remeshed(Surface given, const ImpactorSetup& setup) {
  if (!setup.coarsen && setup.refine.empty()) return {std::move(given), std::nullopt};
  if (given.report().cut_edges > 0) {
    throw SetupError("impactors." + setup.name,
                     "the surface is cut along non-manifold edges (more than two panels), where panels would no longer meet after bisection or merging; delete "
                     "the inner walls, or omit refine and coarsen.");
  }
  Remeshing remeshing{.given = given.report()};
  Surface surface = std::move(given);
  if (setup.coarsen) {
    const double any_length = std::numeric_limits<double>::infinity();
    const fccda::Coarsened coarse =
        coarsen(surface, {.max_deviation = setup.coarsen->max_deviation, .max_edge_length = setup.coarsen->max_edge_length.value_or(any_length)});
    remeshing.coarsened = CoarseningReport{coarse.panels.panels.size(), coarse.distance, coarse.volume_change};
    try {
      surface = surface_of(coarse.panels, setup.name);
      fccda::expect_no_pockets(self_intersections(surface, fccda::Bvh(surface)), setup.name);
    } catch (const fccda::InputError& error) {
      throw SetupError("impactors." + setup.name + ".coarsen", error.in_words_of(deck_words) + " This results from coarsening; use a smaller max_deviation.");
    }
  }
  if (!setup.refine.empty()) {
    std::vector<fccda::Refinement> refinements;
    for (const RefinementSetup& refinement : setup.refine) refinements.push_back(refinement_of(refinement));
    try {
      surface = surface_of(refine(surface, refinements), setup.name);
    } catch (const fccda::InputError& error) {
      throw SetupError("impactors." + setup.name + ".refine", error);
    }
    remeshing.is_refined = true;
  }
  return {std::move(surface), std::move(remeshing)};
}

}  // namespace perimpact
