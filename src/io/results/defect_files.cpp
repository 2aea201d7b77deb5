#include "io/results/defect_files.hpp"

#include <cstdint>
#include <vector>

#include "io/output/vtp.hpp"

namespace perimpact {

void write_defects(const std::filesystem::path& path, const fccda::Panels& panels, std::span<const fccda::Defect> defects) {
  std::vector<fccda::Vec3d> vertices;
  std::vector<int> number(panels.vertices.size(), -1);
  std::vector<std::array<int, 4>> shown;
  std::vector<std::int32_t> kinds, numbers;
  for (const fccda::Defect& defect : defects) {
    for (const int panel : defect.panels) {
      std::array<int, 4> corners = panels.panels[static_cast<std::size_t>(panel)];
      for (int& corner : corners) {
        if (corner < 0) continue;
        int& renumbered = number[static_cast<std::size_t>(corner)];
        if (renumbered < 0) renumbered = static_cast<int>(vertices.size()), vertices.push_back(panels.vertices[static_cast<std::size_t>(corner)]);
        corner = renumbered;
      }
      shown.push_back(corners);
      kinds.push_back(static_cast<std::int32_t>(defect.kind));
      numbers.push_back(panel);
    }
  }
  output::write_vtp(path,
                    {.points = output::coordinates(vertices),
                     .panels = shown,
                     .cell_arrays = {{"defect", 1, std::span<const std::int32_t>(kinds)}, {"panel", 1, std::span<const std::int32_t>(numbers)}}},
                    output::Compression::zlib);
}

}  // namespace perimpact
