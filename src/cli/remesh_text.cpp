#include "cli/remesh_text.hpp"

#include <fmt/format.h>

namespace perimpact {

std::string remesh_text(const Impactor& impactor) {
  if (!impactor.remeshing()) return "";
  const auto& [given, coarsened, is_refined] = *impactor.remeshing();
  const auto row = [](const char* name, const std::string& value) { return fmt::format("  {:<18}{}\n", name, value); };
  std::string text = row(
      "as given", fmt::format("{} panels ({} triangles, edges {:.4g} to {:.4g} m)", given.panels, given.triangles, given.shortest_edge, given.longest_edge));
  if (coarsened) {
    const std::string volume =
        given.volume > 0 ? fmt::format(", change of volume {:+.3g} m3 ({:+.2g} %)", coarsened->volume_change, 100 * coarsened->volume_change / given.volume)
                         : "";
    text += row("coarsened", fmt::format("to {} triangles; maximum deviation of the surface {:.3g} m{}", coarsened->panels, coarsened->distance, volume));
  }
  if (is_refined) text += row("refined", fmt::format("to {} triangles", impactor.surface().report().triangles));
  return text;
}

}  // namespace perimpact
