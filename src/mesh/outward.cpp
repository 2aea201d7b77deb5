#include "mesh/outward.hpp"

#include <cmath>
#include <vector>

#include "mesh/defects.hpp"
#include "mesh/mass_properties.hpp"
#include "mesh/nesting.hpp"

namespace fccda {
namespace {

void expect_declared(Orientation outside, const LinkedTriangles& surface, const std::string& name) {
  if (outside != Orientation::undeclared) return;
  const std::vector<std::size_t> boundary_loops = triangles_on_boundary(surface);
  throw SurfaceError(name + ": the surface is open: " + std::to_string(boundary_loops.size()) +
                         (boundary_loops.size() == 1 ? " edge belongs" : " edges belong") + " to one panel only, the first to panel " +
                         std::to_string(surface.triangles[boundary_loops.front()].panel) +
                         " (counted from 0); close the holes, or specify which side is outside {}.",
                     {DefectKind::rim, panels_of(surface.triangles, boundary_loops)}, Advice::declare_orientation);
}

/// True if the volume is within rounding error of zero, as for a sheet folded onto itself.
bool is_zero_volume(double volume, const LinkedTriangles& surface, const std::vector<std::size_t>& triangles) {
  Box bounds;
  for (const std::size_t t : triangles) {
    for (std::size_t c = 0; c < 3; ++c) bounds.include(surface.corner(t, c));
  }
  double area = 0;
  for (const std::size_t t : triangles) area += 0.5 * norm(cross(surface.corner(t, 1) - surface.corner(t, 0), surface.corner(t, 2) - surface.corner(t, 0)));
  return std::fabs(volume) <= 1e-12 * area * norm(bounds.size());
}

}  // namespace

Outward orient_outward(LinkedTriangles& surface, const Components& components, Orientation outside, const std::string& name) {
  std::vector<std::vector<std::size_t>> members(components.count);
  std::vector<bool> is_closed(components.count, true);
  bool all_closed = true;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto component = static_cast<std::size_t>(components.of_triangle[t]);
    members[component].push_back(t);
    for (const int beyond : surface.neighbours[t]) {
      if (beyond < 0) is_closed[component] = all_closed = false;
    }
  }
  if (!all_closed) expect_declared(outside, surface, name);
  if (all_closed && outside == Orientation::reversed)
    throw InputError(name +
                     ": the surface is closed, so its outside is known, and cannot be declared as reversed; omit the orientation, or for a container leave one "
                     "side open, such as its lid, or give its walls a thickness by a second surface inside.");

  const Nesting nesting = find_nesting(surface, components, is_closed);
  Outward out;
  for (std::size_t component = 0; component < components.count; ++component) {
    bool turn = outside == Orientation::reversed;
    if (is_closed[component]) {
      const double volume = signed_volume(surface, members[component]);
      if (is_zero_volume(volume, surface, members[component])) {
        throw SurfaceError(name + ": the closed part with panel " + std::to_string(surface.triangles[members[component][0]].panel) +
                               " (counted from 0) encloses no volume, so it has no inside; give it a thickness, or delete one of its two sides.",
                           {DefectKind::no_volume, panels_of(surface.triangles, members[component])});
      }
      const bool is_cavity = nesting.depth[component] % 2 == 1;
      turn = (volume < 0) != is_cavity;
      out.cavities += is_cavity ? 1 : 0;
      out.flipped += turn ? 1 : 0;
    }
    std::size_t solid = component;
    while (nesting.depth[solid] % 2 == 1) solid = static_cast<std::size_t>(nesting.container[solid]);
    out.solid_of_component.push_back(static_cast<int>(solid));
    if (!turn) continue;
    for (const std::size_t t : members[component]) flip(surface.triangles[t], surface.neighbours[t]);
  }
  return out;
}

}  // namespace fccda
