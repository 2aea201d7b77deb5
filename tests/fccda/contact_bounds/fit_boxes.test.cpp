#include "fccda/contact_bounds/fit_boxes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "fccda/contact_bounds/boxes.hpp"
#include "fccda/contact_bounds/scenes.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

TEST_CASE("fit boxes: fitted boxes contain the surface exactly, by the check applied to specified ones") {
  for (const fixtures::ToBound& body : fixtures::surfaces_to_bound()) {
    CAPTURE(body.name);
    for (const int most : {1, 2, 5, 16}) {
      const std::vector<Box> boxes = fit_boxes(body.surface, {.most = most, .gain = 0});
      CHECK(boxes.size() <= static_cast<std::size_t>(most));
      std::vector<BoxUnion::Shape> shapes;
      for (const Box& box : boxes) shapes.push_back({box.size(), box.centre()});
      CHECK_FALSE(BoxUnion(shapes, body.surface, Beyond::error).clips());
    }
  }
}

TEST_CASE("fit boxes: one box is the bounding box, and more never have a larger volume") {
  for (const fixtures::ToBound& body : fixtures::surfaces_to_bound()) {
    CAPTURE(body.name);
    const Box& bounds = body.surface.report().bounds;
    double before = 1e300;
    for (const int most : {1, 2, 3, 6, 12, 24}) {
      const double volume = volume_of(fit_boxes(body.surface, {.most = most, .gain = 0}));
      // 1e-6: boxes are widened by 1e-8 of the coordinates on six sides
      if (most == 1) CHECK(volume == fixtures::relative(volume_of(bounds), 1e-6));
      CHECK(volume <= before * (1 + 1e-6));
      before = volume;
    }
  }
}

TEST_CASE("fit boxes: a step is exactly two boxes, a cube one, and further splits save nothing") {
  // The face of the step lies in the splitting plane and goes with the higher part, whichever side that is on.
  const Panels rising = fixtures::step_body(), falling = fixtures::moved(rising, [](const Vec3d&p) { return Vec3d{2 - p.x, 1 - p.y, p.z}; });
  const Surface cube(fixtures::unit_cube());
  for (const Panels& panels : {rising, falling}) {
    const Surface step(panels);
    REQUIRE(step.is_closed());
    CHECK(step.report().volume == fixtures::relative(3, 1e-12));
    const std::vector<Box> two = fit_boxes(step, {.most = 30, .gain = 0});
    CHECK(two.size() == 2);
    CHECK(volume_of(two) == fixtures::relative(3, 1e-6));  // widened by 1e-8 of the coordinates
  }
  CHECK(fit_boxes(cube, {.most = 30, .gain = 0}).size() == 1);
}

TEST_CASE("fit boxes: splitting stops when a split would save less than the requested gain") {
  const Surface hull(fixtures::hull_like());
  const double whole = volume_of(hull.report().bounds);
  std::size_t fewest = 1000;
  for (const double gain : {0.001, 0.01, 0.1, 0.9}) {
    const std::vector<Box> boxes = fit_boxes(hull, {.most = 1000, .gain = gain});
    CHECK(boxes.size() <= fewest);
    fewest = boxes.size();
    // each split saved its share
    CHECK(volume_of(boxes) <= (1 - gain * static_cast<double>(boxes.size() - 1)) * whole * (1 + 1e-6));
  }
  CHECK(fewest == 1);
}

TEST_CASE("fit boxes: the interior of a thick body is contained, not only its skin") {
  // A ball fills π/6 of its box; boxes around its skin alone would fill less.
  const Surface ball(make_sphere({.diameter = 1, .edge_length = 0.1}));
  const double volume = volume_of(fit_boxes(ball, {.most = 200, .gain = 0}));
  CHECK(volume >= ball.report().volume);
  CHECK(volume < 0.7);  // π/6 = 0.52
}

TEST_CASE("fit boxes: for an open surface the boxes contain only its wall") {
  Panels open = fixtures::torus(1, 0.3, 32, 4);
  open.panels.resize(open.panels.size() - 4);  // a slice of the ring is missing
  const Surface surface(open, {.orientation = Orientation::normals});
  REQUIRE_FALSE(surface.is_closed());
  const BoxUnion boxes(fit_boxes(surface, {.most = 40, .gain = 0}));
  CHECK_FALSE(boxes.contains({0, 0, 0}));
  std::mt19937_64 random(6);
  for (int k = 0; k < 1000; ++k) CHECK(boxes.contains(fixtures::random_place(random, surface)));
}
