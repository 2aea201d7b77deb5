#include "mesh/panel_faces.hpp"

#include <algorithm>

namespace fccda {

PanelFaces::PanelFaces(const Surface& surface) : faces_(surface.report().panels), first_neighbour_(surface.report().panels + 1, 0) {
  const auto triangles = surface.triangles();
  const auto panel_of = [&](std::size_t t) { return static_cast<std::size_t>(triangles[t].panel); };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Vec3d a = surface.corner(t, 0), b = surface.corner(t, 1), c = surface.corner(t, 2);
    const Vec3d normal = 0.5 * cross(b - a, c - a);
    const double area = norm(normal);
    PanelFace& face = faces_[panel_of(t)];
    face.area += area;
    face.middle += area / 3 * (a + b + c);
    face.normal += normal;
  }
  for (PanelFace& face : faces_) {
    if (face.area > 0) face.middle = face.middle / face.area;
    face.normal = normalised(face.normal);
  }

  // two passes: count the neighbours of each panel, then list them
  const auto for_each_pair = [&](const auto& visit) {
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t e = 0; e < 3; ++e)
        if (const int beyond = surface.neighbour(t, e); beyond >= 0 && panel_of(static_cast<std::size_t>(beyond)) != panel_of(t))
          visit(panel_of(t), triangles[static_cast<std::size_t>(beyond)].panel);
  };
  for_each_pair([&](std::size_t panel, int) { ++first_neighbour_[panel + 1]; });
  for (std::size_t panel = 0; panel < faces_.size(); ++panel) first_neighbour_[panel + 1] += first_neighbour_[panel];
  neighbours_.resize(first_neighbour_.back());
  std::vector<std::size_t> next(first_neighbour_.begin(), first_neighbour_.end() - 1);
  for_each_pair([&](std::size_t panel, int beyond) { neighbours_[next[panel]++] = beyond; });
}

std::vector<int> PanelFaces::around(std::size_t panel, double radius) const {
  constexpr double cosine = 0.5;  // not 0: rounding must not decide for the two sides of a right-angled edge
  const PanelFace& centre = faces_[panel];
  std::vector<int> found{static_cast<int>(panel)};  // ascending
  std::vector<int> waiting = found;
  while (!waiting.empty()) {
    const auto at = static_cast<std::size_t>(waiting.back());
    waiting.pop_back();
    for (const int next : neighbours(at)) {
      const PanelFace& face = faces_[static_cast<std::size_t>(next)];
      if (norm(face.middle - centre.middle) > radius || dot(face.normal, centre.normal) <= cosine) continue;
      const auto place = std::lower_bound(found.begin(), found.end(), next);
      if (place != found.end() && *place == next) continue;
      found.insert(place, next);
      waiting.push_back(next);
    }
  }
  return found;
}

}  // namespace fccda
