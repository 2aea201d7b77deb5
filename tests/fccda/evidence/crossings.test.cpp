// Completeness of the swept detector: ten shapes, steps from 1e-4 to 4 % of their size, 24 orientations, moving points and moving bodies.
// detection_table.cpp does the same with more paths, and for the detector of Zhang et al.
#include <doctest/doctest.h>

#include "fccda/evidence/score.hpp"
#include "fccda/evidence/shapes.hpp"

using namespace evidence;

TEST_CASE("evidence: rays and solid angles agree on the side of every shape that a point is on") {
  for (const fixtures::Body& shape : shapes()) {
    CAPTURE(std::string(shape.name));
    const Truth truth{Surface(shape.panels)};
    std::mt19937_64 random(51);
    std::size_t inside = 0;
    for (int k = 0; k < 50; ++k) {
      const Vec3d point = fixtures::random_in_box(random, {-0.5, -0.2, -0.01}, {0.5, 0.2, 0.01});
      CHECK(truth.inside(point) == truth.soup().inside(point));
      inside += truth.inside(point);
    }
    CHECK(inside > 0);
  }
}

TEST_CASE("evidence: swept finds every true crossing and no other, leaves no point inside and moves none through") {
  for (const fixtures::Body& shape : shapes()) {
    CAPTURE(std::string(shape.name));
    const auto surface = fixtures::surface_of(shape.panels);
    const Truth truth(*surface);
    for (const double radius : {0.0, 0.005}) {
      CAPTURE(radius);
      Swept detector(surface, Unbounded{}, radius);
      for (const double step : {1e-4, 1e-3, 1e-2, 4e-2}) {
        CAPTURE(step);
        for (const Way way : {Way::points_move, Way::body_moves, Way::body_turns}) {
          CAPTURE(static_cast<int>(way));
          Score total;
          for (const Flight& flight : flights(truth, {.radius = radius, .step = step, .way = way, .contacts = 72, .past = 24, .seed = 52}))
            total += score(detector, truth, flight, way, radius, [](const Passage&, std::size_t) {});
          CHECK(total.contacts == 72);
          CHECK(total.found == total.contacts);
          CHECK(total.past == 24);
          CHECK(total.invented == 0);
          CHECK(total.inside == 0);
          CHECK(total.thrown == 0);
        }
      }
    }
  }
}

TEST_CASE("evidence: a point that rests on an edge of a box leaves over it, close past the plane of the adjacent face, without contact") {
  const auto box = fixtures::surface_of(fixtures::box());  // edge along y at x = 0.5, z = 0.2
  for (const double height : {1e-13, 1e-12, 1e-11, 1e-10}) {
    CAPTURE(height);
    Swept detector(box, Unbounded{}, 0);
    const Vec3d start{0.5 + height, 0.05, 0.2 + height};
    CHECK(fixtures::detect(detector, fixtures::points_on({{start, start + Vec3d{0.1, 0, -0.1}}, {start, start + Vec3d{-0.1, 0, 0.1}}})).empty());
    CHECK(fixtures::detect(detector, fixtures::points_on({{start, start + Vec3d{-0.1, 0, -0.01}}})).size() == 1);
  }
}
