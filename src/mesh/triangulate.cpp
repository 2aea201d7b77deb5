#include "mesh/triangulate.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/duplicates.hpp"
#include "mesh/slivers.hpp"

namespace fccda {
namespace {

class Splitter {
 public:
  Splitter(const std::vector<Vec3d>& vertices, double flat) : vertices_(vertices), flat_(flat) {}

  std::array<std::array<int, 3>, 2> split(const std::array<int, 4>& q) const {
    using Halves = std::array<std::array<int, 3>, 2>;
    const Halves from_first{{{q[0], q[1], q[2]}, {q[0], q[2], q[3]}}};
    const Halves from_second{{{q[1], q[2], q[3]}, {q[1], q[3], q[0]}}};
    // The diagonals of a rectangle differ by rounding only. Neither rounding nor the panel's first corner may decide: the same rectangle
    // in a neighbouring part would be split differently.
    constexpr double rounding = 1e-10;
    const double first = squared_norm(at(q[0]) - at(q[2])), second = squared_norm(at(q[1]) - at(q[3]));
    const bool are_alike = std::fabs(first - second) <= rounding * std::max(first, second);
    const bool second_is_shorter = are_alike ? std::min(q[1], q[3]) < std::min(q[0], q[2]) : second < first;
    const Halves& shorter = second_is_shorter ? from_second : from_first;
    const Halves& longer = second_is_shorter ? from_first : from_second;
    return !agree(shorter) && agree(longer) ? longer : shorter;
  }

 private:
  const Vec3d& at(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)]; }
  Vec3d doubled_area(const std::array<int, 3>& t) const { return cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])); }
  bool agree(const std::array<std::array<int, 3>, 2>& halves) const {
    return has_area(vertices_, halves[0], flat_) && has_area(vertices_, halves[1], flat_) && dot(doubled_area(halves[0]), doubled_area(halves[1])) > 0;
  }

  const std::vector<Vec3d>& vertices_;
  double flat_;
};

}  // namespace

Triangulation triangulate(const Panels& panels, double flat) {
  const Splitter splitter(panels.vertices, flat);
  Triangulation out;
  out.triangles.reserve(panels.panels.size());
  const auto add = [&](const std::array<int, 3>& vertex, std::size_t panel) {
    if (vertex[0] == vertex[1] || vertex[1] == vertex[2] || vertex[2] == vertex[0]) {
      ++out.degenerate;
    } else {
      out.triangles.push_back({vertex, static_cast<int>(panel)});
    }
  };
  for (std::size_t p = 0; p < panels.panels.size(); ++p) {
    const auto& panel = panels.panels[p];
    if (panel[3] < 0) {
      add({panel[0], panel[1], panel[2]}, p);
    } else {
      for (const auto& half : splitter.split(panel)) add(half, p);
    }
  }
  const Duplicates duplicates = drop_duplicates(out.triangles, panels.vertices);
  out.duplicate = duplicates.repeated;
  out.back_to_back = duplicates.back_to_back;
  out.degenerate += absorb_slivers(out.triangles, panels.vertices, flat);
  return out;
}

}  // namespace fccda
