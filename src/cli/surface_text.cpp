#include "cli/surface_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/results/run_report.hpp"

namespace perimpact {

std::string surface_text(const fccda::SurfaceReport& report) {
  std::string text;
  const auto row = [&](const char* name, const std::string& value) { text += fmt::format("  {:<18}{}\n", name, value); };
  row("panels", fmt::format("{} ({} triangles, {} vertices)", report.panels, report.triangles, report.vertices));
  const fccda::Vec3d size = report.bounds.size();
  row("size", fmt::format("{:.4g} x {:.4g} x {:.4g} m", size.x, size.y, size.z));
  row("edges", fmt::format("{:.4g} to {:.4g} m", report.shortest_edge, report.longest_edge));
  row("closure", report.boundary_edges == 0 ? std::string(word_for(report.closure))
                                            : fmt::format("{}, {} boundary edges", word_for(report.closure), report.boundary_edges));
  row("components", fmt::format("{}", report.components) + (report.cavities > 0 ? fmt::format(", {} of them cavities", report.cavities) : ""));
  row("area", fmt::format("{:.5g} m2", report.area));
  if (report.closure == fccda::Closure::closed) row("volume", fmt::format("{:.5g} m3", report.volume));
  row("centroid", fmt::format("({:.4g}, {:.4g}, {:.4g}) m", report.centroid.x, report.centroid.y, report.centroid.z));
  if (report.closure == fccda::Closure::closed) {
    const fccda::Vec3d &d = report.inertia_diagonal, &p = report.inertia_products;
    row("inertia",
        fmt::format("per density, about the centroid: xx {:.4g}, yy {:.4g}, zz {:.4g}, yz {:.3g}, zx {:.3g}, xy {:.3g} m5", d.x, d.y, d.z, p.x, p.y, p.z));
  }
  constexpr std::size_t most = 40;  // parts that fit on a terminal
  const bool has_names = report.parts.size() > 1 || !report.parts[0].name.empty();
  for (std::size_t k = 0; has_names && k < std::min(most, report.parts.size()); ++k) {
    const fccda::PartReport& part = report.parts[k];
    row(k == 0 ? "parts" : "", fmt::format("{}: {} panels, {:.5g} m2", part.name.empty() ? "(no name)" : part.name, part.panels, part.area));
  }
  if (report.parts.size() > most) row("", fmt::format("and {} more", report.parts.size() - most));
  const auto repaired = [&](std::size_t count, const char* what) {
    if (count > 0) row("repaired", fmt::format("{} {}", count, what));
  };
  repaired(report.welded, "coincident vertices merged");
  repaired(report.degenerate, "triangles of zero area removed");
  repaired(report.duplicate, "duplicate panels removed");
  repaired(report.back_to_back, "pairwise back-to-back triangles removed");
  if (report.non_manifold_edge_count > 0 && report.cut_edges == 0) repaired(report.non_manifold_edge_count, "non-manifold edges, where parts touch, paired");
  repaired(report.rewound, "triangles reoriented to match their neighbours");
  if (report.flipped) row("repaired", "inward normals reversed");
  return text;
}

}  // namespace perimpact
