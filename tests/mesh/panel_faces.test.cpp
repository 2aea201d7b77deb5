#include "mesh/panel_faces.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"

using namespace fccda;

TEST_CASE("panel faces: the areas of all panels add up to the surface, and each has its four neighbours on a box of quads") {
  const Surface surface(make_box({.size = {1, 0.6, 0.4}, .edge_length = 0.2, .panels = PanelKind::quads}));
  const PanelFaces faces(surface);
  REQUIRE(faces.size() == 2 * (5 * 3 + 3 * 2 + 5 * 2));
  double area = 0;
  for (std::size_t p = 0; p < faces.size(); ++p) {
    CHECK(faces[p].area == fixtures::relative(0.04, 1e-12));  // sums of products of lengths of order one
    area += faces[p].area;
    std::vector<int> beyond(faces.neighbours(p).begin(), faces.neighbours(p).end());
    std::sort(beyond.begin(), beyond.end());
    CHECK(beyond.size() == 4);
    CHECK(std::unique(beyond.begin(), beyond.end()) == beyond.end());
    for (const int other : beyond) CHECK(norm(faces[static_cast<std::size_t>(other)].middle - faces[p].middle) < 0.2 + 1e-12);
  }
  CHECK(area == fixtures::relative(surface.report().area, 1e-12));
}

TEST_CASE("panel faces: the surroundings of a panel agree with a search over all panels of that side, and exclude panels round a corner") {
  const PanelFaces faces(Surface(make_box({.size = {1, 1, 0.02}, .edge_length = 0.1, .panels = PanelKind::triangles})));
  for (std::size_t p = 0; p < faces.size(); p += 7) {
    std::vector<int> expected;  // the box's faces are convex, so near panels on the same side are also connected
    for (std::size_t q = 0; q < faces.size(); ++q)
      if (norm(faces[q].middle - faces[p].middle) <= 0.25 && faces[q].normal == faces[p].normal) expected.push_back(static_cast<int>(q));
    CHECK(expected.size() > 1);
    CHECK(faces.around(p, 0.25) == expected);
  }
}
