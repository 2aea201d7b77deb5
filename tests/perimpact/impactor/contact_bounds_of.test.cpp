#include "perimpact/impactor/contact_bounds_of.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "fixtures/propeller.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "perimpact/deck_model/setup_error.hpp"

using namespace perimpact;
using fccda::BoxUnion;
using fccda::CylinderSectors;
using fccda::Surface;

namespace {

Surface block() { return Surface(fccda::make_box({.size = {2, 1, 1}, .edge_length = 1})); }

std::string complaint(const ContactBoundsSetup& setup, const Surface& surface) {
  try {
    contact_bounds_of(setup, surface, "ram");
  } catch (const SetupError& error) {
    return error.key() + ": " + error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("contact bounds of: every kind of bounds in a Setup is built, and reports fitted values") {
  const Surface surface = block();
  const auto made = [&](auto shape) { return contact_bounds_of({.shape = shape}, surface, "ram"); };
  CHECK(std::holds_alternative<fccda::Unbounded>(made(std::monostate{}).region));

  const ImpactorBounds box = made(BoxRegionSetup{.size = {2, 1, 1}});
  CHECK(std::get<BoxUnion>(box.region).boxes().size() == 1);
  CHECK(box.fitted == "");

  const ImpactorBounds given = made(BoxUnionBoundsSetup{.boxes = {{"bow", {1, 1, 1}, {0.5, 0, 0}}, {"stern", {1, 1, 1}, {-0.5, 0, 0}}}});
  CHECK(std::get<BoxUnion>(given.region).boxes().size() == 2);
  CHECK(given.fitted == "");

  const ImpactorBounds fitted = made(BoxUnionBoundsSetup{.count = 5});
  CHECK(std::get<BoxUnion>(fitted.region).boxes().size() == 1);  // a block needs no more
  CHECK(fitted.fitted == "boxes fitted to the surface");

  const ImpactorBounds sectors =
      made(CylinderSectorsBoundsSetup{.axis = Vec3d{1, 0, 0}, .point = Vec3d{}, .radius = 0.8, .length = 2.0, .hub_radius = 0.8, .blades = 1});
  CHECK(std::get<CylinderSectors>(sectors.region).volume() == fixtures::relative(std::numbers::pi * 0.8 * 0.8 * 2, 1e-12));
  CHECK(sectors.fitted ==
        "sector_angle, start_angle fitted to the surface; the angular gaps between its blades are negligible, so that the fan is the whole cylinder");

  const ImpactorBounds chosen = made(AutoBoundsSetup{});
  CHECK(std::holds_alternative<BoxUnion>(chosen.region));
  CHECK(chosen.fitted.ends_with("chosen: the bounding box"));
}

TEST_CASE("contact bounds of: count and gain limit the fitted boxes") {
  const Surface surface(fixtures::propeller({.edge_length = 0.06}));
  const auto boxes = [&](const BoxUnionBoundsSetup& shape) {
    return std::get<BoxUnion>(contact_bounds_of({.shape = shape}, surface, "ram").region).boxes().size();
  };
  CHECK(boxes({.count = 3}) == 3);
  CHECK(boxes({.gain = 0.9}) == 1);
  CHECK(boxes({}) > boxes({.gain = 0.05}));
  CHECK(boxes({.count = 40, .gain = 0.0}) == 40);
}

TEST_CASE("contact bounds of: a surface that exceeds them is refused at their key, unless clipped") {
  const Surface surface = block();
  const ContactBoundsSetup small{.shape = BoxUnionBoundsSetup{.boxes = {{"bow", {0.5, 1, 1}, {0.75, 0, 0}}}}};
  CHECK(complaint(small, surface).starts_with("impactors.ram.contact_bounds: contact bounds: 18 of 20 panels extend beyond the box by up to 1.5 m"));
  ContactBoundsSetup clipping = small;
  clipping.on_exceed.index = 1;
  CHECK(complaint(clipping, surface) == "");
  CHECK(complaint({.shape = CylinderSectorsBoundsSetup{.radius = 0.3}}, surface).find("extend beyond the cylinder's sectors") != std::string::npos);
}
