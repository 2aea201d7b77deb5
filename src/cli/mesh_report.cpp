#include "cli/mesh_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/row.hpp"
#include "mesh/inspect/boundary_loops.hpp"
#include "mesh/inspect/surface_measures.hpp"
#include "mesh/panel_faces.hpp"

namespace perimpact {

using namespace fccda;

namespace {

std::string place_in_metres(const Vec3d& p) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", p.x, p.y, p.z); }
std::string counted(std::size_t count, const char* one, const char* many) { return fmt::format("{} {}", count, count == 1 ? one : many); }

}  // namespace

std::optional<std::string> unit_suspicion(const SurfaceReport& report) {
  const Vec3d size = report.bounds.size();
  const double largest = std::max({size.x, size.y, size.z});
  constexpr double no_ship = 1000, no_tool = 1e-3;  // [m]
  if (largest > no_ship)
    return fmt::format("{:.4g} m is longer than any ship; if the file is in millimetres, --scale 0.001 (`scale: 0.001` in the deck) makes it {:.4g} m", largest,
                       0.001 * largest);
  if (largest < no_tool)
    return fmt::format("{:.4g} m is smaller than any tool; if the file is in metres, omit the scale, otherwise choose one that converts to metres", largest);
  return std::nullopt;
}

std::optional<std::string> half_suspicion(const Surface& surface) {
  const std::vector<BoundaryLoop> all = boundary_loops(surface);
  const double tolerance = 1e-6 * norm(surface.report().bounds.size());  // floats of binary STL round by less
  constexpr const char* axes[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3 && !all.empty(); ++axis) {
    const bool in_plane = std::all_of(all.begin(), all.end(), [&](const BoundaryLoop& loop) {
      return std::max(std::abs(loop.bounds.low[axis]), std::abs(loop.bounds.high[axis])) <= tolerance;
    });
    if (in_plane)
      return fmt::format("all boundary edges lie in the plane {0} = 0; if the file contains one half, `mirror_merge: {0}` in the deck adds the other",
                         axes[axis]);
  }
  return std::nullopt;
}

std::optional<double> closing_weld(const Panels& panels, const Surface& surface) {
  if (surface.is_closed()) return std::nullopt;
  const double size = norm(surface.report().bounds.size());
  for (const double share : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4}) {
    const double distance = share * size;
    if (distance > 0.5 * surface.report().shortest_edge) break;
    try {
      const Surface welded(panels, {.weld_distance = distance, .orientation = Orientation::normals});
      if (welded.report().triangles < surface.report().triangles) break;
      if (welded.is_closed()) return distance;
    } catch (const InputError&) {
      break;  // merged parts are invalid, also at larger distances
    }
  }
  return std::nullopt;
}

std::string defects_text(const Surface& surface, const SelfIntersections& folds) {
  std::string text;
  const std::vector<BoundaryLoop> all = boundary_loops(surface);
  constexpr std::size_t most = 10;
  for (std::size_t k = 0; k < std::min(most, all.size()); ++k) {
    const Vec3d size = all[k].bounds.size();
    text += row(k == 0 ? "boundary loops" : "",
                fmt::format("{}, length {:.4g} m, extent {:.4g} x {:.4g} x {:.4g} m about {}", counted(all[k].edges, "edge", "edges"), all[k].length, size.x,
                            size.y, size.z, place_in_metres(all[k].bounds.centre())));
  }
  if (all.size() > most) text += row("", fmt::format("and {} more, all shorter", all.size() - most));
  const SurfaceReport& report = surface.report();
  if (report.cut_edges > 0)
    text += row("non-manifold", fmt::format("{} with more than two panels; on {} of them a panel could not be paired and is cut off",
                                            counted(report.non_manifold_edge_count, "edge", "edges"), report.cut_edges));
  for (const Defect& defect : folds.defects) {
    const std::string panels = counted(defect.panels.size(), "panel", "panels");
    if (defect.kind == DefectKind::inside_out)
      text += row("inside out", panels + " intersect such that the surface is inside out between them; a run rejects this, repair the fold");
    else
      text += row("self-intersection", panels + " of one body intersect; " +
                                           (surface.is_closed() ? "nothing is inside out between them, and contact from outside is detected"
                                                                : "whether the surface is inside out between them is undefined where it is open"));
  }
  return text;
}

std::string spacing_text(const Surface& surface, const Bvh& bvh, double spacing) {
  std::string text = fmt::format("  for particles of spacing {:.4g} m\n", spacing);
  const double median = median_panel_size(surface, PanelFaces(surface));
  const char* verdict = median < spacing / 4   ? "finer than useful: below a quarter of the spacing it costs time and memory without more resolution"
                        : median > 2 * spacing ? "sufficient on flat areas; for curved ones, see below"
                                               : "adequate";
  text += row("  median panel", fmt::format("{:.4g} m, {:.3g} spacings: {}", median, median / spacing, verdict));
  const Facet facet = coarsest_facet(surface);
  if (facet.panel >= 0)
    text += row("  chord error",
                fmt::format("at most {:.3g} m, {:.2g} spacings, at panel {}, {}: {}", facet.sagitta, facet.sagitta / spacing, facet.panel,
                            place_in_metres(facet.place), facet.sagitta > spacing / 2 ? "too coarse there if the surface is curved" : "sufficient"));
  constexpr std::size_t most_rays = 3000;
  const std::vector<Thickness> all = thicknesses(surface, bvh, most_rays);
  const auto thinnest = std::min_element(all.begin(), all.end(), [](const Thickness& a, const Thickness& b) { return a.thickness < b.thickness; });
  if (thinnest != all.end())
    text += row("  wall thickness", fmt::format("{:.3g} m, {:.2g} spacings, at panel {}, {}; the motion per step must be smaller", thinnest->thickness,
                                                thinnest->thickness / spacing, thinnest->panel, place_in_metres(thinnest->place)));
  return text;
}

}  // namespace perimpact
