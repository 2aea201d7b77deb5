#include "fccda/deforming/step_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/finite.hpp"
#include "mesh/inspect/self_intersections.hpp"

namespace fccda {

namespace {

std::string panels_in_words(std::size_t count) { return std::to_string(count) + (count == 1 ? " panel" : " panels"); }

double longest_edge(const Corners& t) { return std::sqrt(std::max({squared_norm(t.b - t.a), squared_norm(t.c - t.b), squared_norm(t.a - t.c)})); }

Vec3d normal_of(const Corners& t) { return cross(t.b - t.a, t.c - t.a); }

}  // namespace

std::vector<std::string> step_warnings(const DeformingSurface& surface) {
  std::set<int> fast, turned;
  double furthest = 0;
  int fastest = -1;
  const std::span<const Triangle> triangles = surface.at_t1().triangles();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [from, to] = surface.triangle(t);
    const int panel = triangles[t].panel;
    const double travel = std::sqrt(std::max({squared_norm(to.a - from.a), squared_norm(to.b - from.b), squared_norm(to.c - from.c)}));
    const double edges = travel / longest_edge(from);
    if (edges > 1) fast.insert(panel);
    if (edges > furthest) furthest = edges, fastest = panel;
    if (dot(normal_of(from), normal_of(to)) < 0) turned.insert(panel);
  }
  std::vector<std::string> sentences;
  if (!fast.empty())
    sentences.push_back(
        "deforming surface: " + panels_in_words(fast.size()) + " move farther than their longest edge in this step, panel " + std::to_string(fastest) + " by " +
        in_words(furthest) +
        " of it. No contact is missed, but all that a panel passes in the step is relocated to where it ends; use a shorter step for the forces.");
  if (!turned.empty())
    sentences.push_back("deforming surface: the normal of " + panels_in_words(turned.size()) + " turns by more than 90° in this step, the first is panel " +
                        std::to_string(*turned.begin()) + ". Vertices move straight within a step, which shrinks what rotates; use a shorter step.");
  const SelfIntersections found = self_intersections(surface.at_t1(), surface.bvh_t1());
  if (found.crossings == 0) return sentences;
  std::set<int> crossing;
  bool has_pockets = false;
  for (const Defect& defect : found.defects) {
    crossing.insert(defect.panels.begin(), defect.panels.end());
    has_pockets = has_pockets || defect.kind == DefectKind::inside_out;
  }
  std::string sentence = "deforming surface: " + panels_in_words(crossing.size()) + " pass through others at the end of this step, the first is panel " +
                         std::to_string(*crossing.begin()) + ". No crossing is missed, but between two layers the side of the nearest panel counts";
  if (has_pockets) sentence += ", and the surface is inside out between some of them";
  sentences.push_back(sentence + "; stop the structure from passing through itself.");
  return sentences;
}

}  // namespace fccda
