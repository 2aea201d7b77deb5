#include "fccda/contact_bounds/bounds_panels.hpp"

#include <doctest/doctest.h>

#include "fccda/contact_bounds/scenes.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

/// By the divergence theorem, a third of the sum of point · area vector over the panels; negative if they faced inward.
double volume_of(const Panels& panels) {
  double thrice = 0;
  fixtures::for_each_triangle(panels, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) { thrice += dot(a, 0.5 * cross(b - a, c - a)); });
  return thrice / 3;
}

}  // namespace

TEST_CASE("bounds panels: the panels of boxes enclose them, facing outward") {
  const Box boxes[] = {{{-1, 2, 3}, {1, 5, 7}}, {{0, 0, 0}, {0.5, 0.25, 0.125}}};
  const Panels panels = panels_of(boxes);
  CHECK(panels.panels.size() == 12);
  CHECK(volume_of(panels) == fixtures::relative(2 * 3 * 4 + 0.5 * 0.25 * 0.125, 1e-12));
}

TEST_CASE("bounds panels: the panels of all contact bounds are closed, face outward and enclose their volume, and unbounded has none") {
  for (const fixtures::ToBound& body : fixtures::surfaces_to_bound()) {
    for (const fixtures::NamedRegion& region : fixtures::every_region(body.surface)) {
      CAPTURE(body.name);
      CAPTURE(region.name);
      const Panels panels = bounds_panels(region.region);
      if (std::holds_alternative<Unbounded>(region.region)) {
        CHECK(panels.panels.empty());
        continue;
      }
      // A circle of 72 edges has 0.13 % less area than a round one; sectors of few edges likewise.
      CHECK(volume_of(panels) == fixtures::relative(std::visit([](const auto& its) { return its.volume(); }, region.region), 2e-3));
    }
  }
}
