#include "mesh/inspect/surface_measures.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"

using namespace fccda;

namespace {

Surface box(const Vec3d& size, double panel, PanelKind kind = PanelKind::quads) { return Surface(make_box({size, panel, kind})); }

Surface cylinder(double panel) { return Surface(make_cylinder({.diameter = 2, .height = 1, .edge_length = panel})); }

}  // namespace

TEST_CASE("surface measures: the median panel of a box has the requested size, in quads and in triangles") {
  for (const PanelKind kind : {PanelKind::quads, PanelKind::triangles}) {
    const Surface surface = box({1, 1, 1}, 0.1, kind);
    CHECK(median_panel_size(surface, PanelFaces(surface)) == fixtures::relative(0.1, 1e-12));
  }
}

TEST_CASE("surface measures: the facets of a cylinder deviate from it by their sagitta, those of a box and its edges not at all") {
  for (const double panel : {0.1, 0.2, 0.5}) {
    const Surface surface = cylinder(panel);
    double inner = 1e300;  // the least distance of the lateral facets' middles from the axis, by the vertices alone
    for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
      if (std::fabs(surface.normal(t).z) > 0.5) continue;
      for (std::size_t e = 0; e < 3; ++e) {
        const Vec3d middle = 0.5 * (surface.corner(t, e) + surface.corner(t, (e + 1) % 3));
        inner = std::min(inner, std::hypot(middle.x, middle.y));
      }
    }
    const Facet facet = coarsest_facet(surface);
    CHECK(facet.sagitta == fixtures::relative(1 - inner, 0.03));  // w θ/8 against R(1 - cos(θ/2)) at θ of up to 30°
    CHECK(std::hypot(facet.place.x, facet.place.y) == fixtures::relative(1, 1e-9));
  }
  CHECK(coarsest_facet(box({1, 0.6, 0.4}, 0.2)).sagitta < 1e-12);  // rounding of normals in a plane
}

TEST_CASE("surface measures: a box has the thickness of its edge lengths, a hollow one that of its wall, an open surface none") {
  const Surface plate = box({1, 0.6, 0.02}, 0.2);
  for (const Thickness& part : thicknesses(plate, Bvh(plate), 1000)) {
    const double expected = std::fabs(part.place.z) > 0.00999 ? 0.02 : std::fabs(part.place.y) > 0.2999 ? 0.6 : 1.0;
    CHECK(part.thickness == fixtures::relative(expected, 1e-9));
  }
  CHECK(thicknesses(plate, Bvh(plate), 1000).size() == plate.triangles().size());
  CHECK(thicknesses(plate, Bvh(plate), 10).size() <= 10);

  const Panels inner = make_box({.size = {0.8, 0.8, 0.8}, .edge_length = 0.4});
  const Surface hollow(fixtures::joined(make_box({.size = {1, 1, 1}, .edge_length = 0.25}), inner));
  REQUIRE(hollow.report().cavities == 1);
  for (const Thickness& part : thicknesses(hollow, Bvh(hollow), 1000)) {
    const double off_edges = std::max({std::min(std::fabs(part.place.x), std::fabs(part.place.y)), std::min(std::fabs(part.place.y), std::fabs(part.place.z)),
                                       std::min(std::fabs(part.place.z), std::fabs(part.place.x))});
    if (off_edges < 0.35) CHECK(part.thickness == fixtures::relative(0.1, 1e-9));  // elsewhere a ray may run along a side wall
  }

  Panels open = make_box({.size = {1, 1, 1}, .edge_length = 0.5});
  open.panels.pop_back();
  const Surface bowl(open, {.orientation = Orientation::normals});
  CHECK(thicknesses(bowl, Bvh(bowl), 1000).empty());
}
