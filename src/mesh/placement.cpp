#include "mesh/placement.hpp"

#include <limits>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/quaternion.hpp"

namespace fccda {
namespace {

void mirror(Panels& panels, MirrorPlane plane, std::size_t first_vertex, std::size_t first_panel) {
  const std::size_t axis = static_cast<std::size_t>(plane) - 1;
  for (std::size_t v = first_vertex; v < panels.vertices.size(); ++v) panels.vertices[v][axis] = 0 - panels.vertices[v][axis];  // avoids -0
  for (std::size_t p = first_panel; p < panels.panels.size(); ++p) {
    auto& panel = panels.panels[p];
    std::swap(panel[1], panel[3] < 0 ? panel[2] : panel[3]);
  }
}

void complete(Panels& panels, MirrorPlane plane) {
  const std::size_t vertices = panels.vertices.size(), count = panels.panels.size();
  if (vertices > std::numeric_limits<int>::max() / 2)
    throw InputError("the surface has " + std::to_string(vertices) + " vertices, too many to add its mirror image; use larger panels.");
  panels.vertices.reserve(2 * vertices);
  panels.panels.reserve(2 * count);
  for (std::size_t v = 0; v < vertices; ++v) panels.vertices.push_back(panels.vertices[v]);
  for (std::size_t p = 0; p < count; ++p) {
    std::array<int, 4> panel = panels.panels[p];
    for (int& vertex : panel) vertex += vertex >= 0 ? static_cast<int>(vertices) : 0;
    panels.panels.push_back(panel);
  }
  const std::size_t parts = panels.part.size();
  for (std::size_t p = 0; p < parts; ++p) panels.part.push_back(panels.part[p]);
  mirror(panels, plane, vertices, count);
}

}  // namespace

void place(Panels& panels, const Placement& placement) {
  for (Vec3d& vertex : panels.vertices) vertex *= placement.scale;
  if (placement.mirror != MirrorPlane::none) mirror(panels, placement.mirror, 0, 0);
  if (placement.mirror_merge != MirrorPlane::none) complete(panels, placement.mirror_merge);
  const Vec3d& angles = placement.rotate;
  const Mat3 turn =
      (Quaternion::from_rotation({0, 0, angles.z}) * Quaternion::from_rotation({0, angles.y, 0}) * Quaternion::from_rotation({angles.x, 0, 0})).matrix();
  const bool is_turned = angles != Vec3d{};  // otherwise coordinates stay bitwise identical
  for (Vec3d& vertex : panels.vertices) vertex = (is_turned ? turn * vertex : vertex) + placement.translate;
}

}  // namespace fccda
