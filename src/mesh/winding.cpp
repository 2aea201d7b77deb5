#include "mesh/winding.hpp"

#include "mesh/defects.hpp"

namespace fccda {
namespace {

/// Two triangles agree if they traverse their common edge in opposite directions.
bool agree(const Triangle& triangle, std::size_t e, const Triangle& beyond) {
  const int from = triangle.vertex[e], to = triangle.vertex[(e + 1) % 3];
  for (std::size_t f = 0; f < 3; ++f) {
    if (beyond.vertex[f] == to && beyond.vertex[(f + 1) % 3] == from) return true;
  }
  return false;
}

}  // namespace

Components orient_consistently(LinkedTriangles& surface, const std::string& name) {
  auto& [vertices, triangles, neighbours] = surface;
  Components out;
  out.of_triangle.assign(triangles.size(), -1);
  std::vector<bool> turned(triangles.size(), false);  // relative to the first triangle of the component
  std::vector<std::size_t> found;                     // of one component, in the order of the breadth-first search
  found.reserve(triangles.size());

  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (out.of_triangle[first] >= 0) continue;
    const int component = static_cast<int>(out.count++);
    found.assign(1, first);
    out.of_triangle[first] = component;
    std::size_t turned_count = 0;
    for (std::size_t next = 0; next < found.size(); ++next) {
      const std::size_t t = found[next];
      for (std::size_t e = 0; e < 3; ++e) {
        if (neighbours[t][e] < 0) continue;
        const auto u = static_cast<std::size_t>(neighbours[t][e]);
        const bool must_turn = turned[t] == agree(triangles[t], e, triangles[u]);
        if (out.of_triangle[u] < 0) {
          out.of_triangle[u] = component;
          turned[u] = must_turn;
          turned_count += must_turn ? 1 : 0;
          found.push_back(u);
        } else if (turned[u] != must_turn) {
          throw SurfaceError(name + ": the panels " + std::to_string(triangles[t].panel) + " and " + std::to_string(triangles[u].panel) +
                                 " (counted from 0) close a Möbius strip, so the surface is not orientable; cut it there or repair the mesh.",
                             {DefectKind::twisted, panels_of(triangles, std::vector{t, u})});
        }
      }
    }
    const bool majority = 2 * turned_count > found.size();
    for (const std::size_t t : found) {
      if (turned[t] == majority) continue;
      flip(triangles[t], neighbours[t]);
      ++out.rewound;
    }
  }
  return out;
}

}  // namespace fccda
