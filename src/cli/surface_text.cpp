#include "cli/surface_text.hpp"

#include <fmt/format.h>

#include "io/results/run_report.hpp"

namespace perimpact {

std::string surface_text(const fccda::SurfaceReport& report) {
  std::string text;
  const auto row = [&](const char* name, const std::string& value) { text += fmt::format("  {:<18}{}\n", name, value); };
  row("panels", fmt::format("{} ({} triangles, {} vertices)", report.panels, report.triangles, report.vertices));
  const Vec3d size = report.bounds.size();
  row("size", fmt::format("{:.4g} x {:.4g} x {:.4g} m", size.x, size.y, size.z));
  row("edges", fmt::format("{:.4g} to {:.4g} m", report.shortest_edge, report.longest_edge));
  row("closure", report.rim_edges == 0 ? std::string(word_for(report.closure)) : fmt::format("{}, {} edges on a rim", word_for(report.closure), report.rim_edges));
  row("components", fmt::format("{}", report.components));
  row("area", fmt::format("{:.5g} m2", report.area));
  if (report.closure == fccda::Closure::closed) row("volume", fmt::format("{:.5g} m3", report.volume));
  row("centroid", fmt::format("({:.4g}, {:.4g}, {:.4g}) m", report.centroid.x, report.centroid.y, report.centroid.z));
  const auto mended = [&](std::size_t count, const char* what) {
    if (count > 0) row("mended", fmt::format("{} {}", count, what));
  };
  mended(report.welded, "vertices merged with one at the same place");
  mended(report.degenerate, "triangles without area dropped");
  mended(report.duplicate, "panels that repeat another dropped");
  mended(report.rewound, "triangles turned to agree with their neighbours");
  if (report.flipped) row("mended", "the normals pointed inward and were turned outward");
  return text;
}

}  // namespace perimpact
