#include "fccda/surface/surface.hpp"

#include <doctest/doctest.h>

using namespace fccda;

TEST_CASE("surface: a closed cube of quads") {
  Panels cube;
  for (int v = 0; v < 8; ++v) cube.vertices.push_back({double(v & 1), double(v >> 1 & 1), double(v >> 2 & 1)});
  cube.add_quad(0, 1, 3, 2);
  cube.add_quad(4, 5, 7, 6);
  cube.add_quad(0, 1, 5, 4);
  cube.add_quad(2, 3, 7, 6);
  cube.add_quad(0, 2, 6, 4);
  cube.add_quad(1, 3, 7, 5);
  const Surface surface(cube);
  CHECK(surface.is_closed());
  CHECK(surface.report().triangles == 12);
  CHECK(surface.report().vertices == 8);
  CHECK(surface.report().volume == doctest::Approx(1));
  CHECK(surface.report().inertia_diagonal.x == doctest::Approx(1 / 6.0));
}
