#include "perimpact/impactor/remeshed.hpp"

#include <doctest/doctest.h>

#include "fixtures/surfaces.hpp"
#include "perimpact/deck_model/setup_error.hpp"

using namespace perimpact;
using fccda::Surface;

namespace {

/// A plate of 1 m in z = 0, of ten times ten quads; normals point up.
fccda::Panels plate() {
  fccda::Panels out;
  for (int j = 0; j <= 10; ++j)
    for (int i = 0; i <= 10; ++i) out.vertices.push_back({0.1 * i, 0.1 * j, 0});
  for (int j = 0; j < 10; ++j)
    for (int i = 0; i < 10; ++i) out.add_quad(11 * j + i, 11 * j + i + 1, 11 * j + i + 12, 11 * j + i + 11);
  return out;
}

}  // namespace

TEST_CASE("remeshed: without keys the surface is unchanged") {
  const Remeshed same = remeshed(Surface(fixtures::unit_cube()), ImpactorSetup{.name = "ship"});
  CHECK(!same.remeshing);
  CHECK(same.surface.report().panels == 6);
}

TEST_CASE("remeshed: panels are merged first and bisected then, and the report on the given surface is kept") {
  const Surface given(plate(), {.orientation = fccda::Orientation::normals});
  ImpactorSetup setup{.name = "ship", .coarsen = CoarseningSetup{.max_deviation = 1e-6}};
  CHECK(remeshed(given, setup).surface.triangles().size() == 2);
  setup.refine.push_back({.name = "corner", .edge_length = 0.1, .box = BoxRegionSetup{.size = {0.2, 0.2, 1}, .centre = {0, 0, 0}}});
  const Remeshed both = remeshed(given, setup);
  CHECK(both.remeshing->given.panels == 100);
  CHECK(both.remeshing->coarsened->panels == 2);
  CHECK(both.remeshing->is_refined);
  CHECK(both.surface.triangles().size() > 4);
  CHECK(both.surface.triangles().size() < 100);
}

TEST_CASE("remeshed: an open surface keeps its outer side, for any orientation of its panels") {
  for (const auto outside : {fccda::Orientation::normals, fccda::Orientation::reversed}) {
    const double up = outside == fccda::Orientation::normals ? 1 : -1;
    const Remeshed both =
        remeshed(Surface(plate(), {.orientation = outside}),
                 ImpactorSetup{.name = "ship", .coarsen = CoarseningSetup{.max_deviation = 1e-6}, .refine = {{.name = "all", .edge_length = 0.3}}});
    CHECK(both.surface.triangles().size() > 4);
    for (std::size_t t = 0; t < both.surface.triangles().size(); ++t) CHECK(both.surface.normal(t).z == up);
  }
}
