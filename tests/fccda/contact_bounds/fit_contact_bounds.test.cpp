#include "fccda/contact_bounds/fit_contact_bounds.hpp"

#include <doctest/doctest.h>

#include "fccda/contact_bounds/boxes.hpp"
#include "fccda/contact_bounds/scenes.hpp"

using namespace fccda;

TEST_CASE("fit contact bounds: a block gets its box, a hull boxes, an oblique shaft a cylinder, and the sentence states this") {
  const auto choice = [](const Panels& panels) { return fit_contact_bounds(Surface(panels)); };
  const FittedBounds block = choice(fixtures::unit_cube()), hull = choice(fixtures::hull_like()),
                     shaft = choice(fixtures::askew(make_cylinder({.diameter = 1, .height = 8, .axis = Axis::z, .edge_length = 0.2})));
  REQUIRE(std::holds_alternative<BoxUnion>(block.region));
  CHECK(std::get<BoxUnion>(block.region).boxes().size() == 1);
  CHECK(block.choice == "of the bounding box, 1 box fills 100 % and a cylinder with sectors 122 %; chosen: the bounding box");
  REQUIRE(std::holds_alternative<BoxUnion>(hull.region));
  CHECK(std::get<BoxUnion>(hull.region).boxes().size() > 1);
  CHECK(hull.choice.ends_with("chosen: the boxes"));
  CHECK(std::holds_alternative<CylinderSectors>(shaft.region));
  CHECK(shaft.choice.ends_with("chosen: the cylinder with sectors"));
}

TEST_CASE("fit contact bounds: the choice never fills more than the bounding box") {
  for (const fixtures::ToBound& body : fixtures::surfaces_to_bound()) {
    CAPTURE(body.name);
    const ContactBounds region = fit_contact_bounds(body.surface).region;
    // 1e-6: boxes are widened by 1e-8 of the coordinates
    CHECK(std::visit([](const auto& its) { return its.volume(); }, region) <= volume_of(body.surface.report().bounds) * (1 + 1e-6));
  }
}

TEST_CASE("fit contact bounds: a flat open surface gets its flat box") {
  Panels square;
  square.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.add_quad(0, 1, 2, 3);
  const ContactBounds region = fit_contact_bounds(Surface(square, {.orientation = Orientation::normals})).region;
  REQUIRE(std::holds_alternative<BoxUnion>(region));
  CHECK(std::get<BoxUnion>(region).contains({0.5, 0.5, 0}));
}
