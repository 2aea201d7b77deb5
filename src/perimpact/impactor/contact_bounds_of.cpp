#include "perimpact/impactor/contact_bounds_of.hpp"

#include <fmt/format.h>

#include <vector>

#include "fccda/contact_bounds/fit_boxes.hpp"
#include "fccda/contact_bounds/fit_contact_bounds.hpp"
#include "fccda/contact_bounds/fit_sectors.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

using namespace fccda;

namespace {

ImpactorBounds made(const std::monostate&, const Surface&, Beyond) { return {Unbounded(), ""}; }

ImpactorBounds made(const BoxRegionSetup& box, const Surface& surface, Beyond beyond) { return {BoxUnion({box.size, box.centre}, surface, beyond), ""}; }

ImpactorBounds made(const BoxUnionBoundsSetup& setup, const Surface& surface, Beyond beyond) {
  if (!setup.boxes.empty()) {
    std::vector<BoxUnion::Shape> shapes;
    for (const BoundsBoxSetup& box : setup.boxes) shapes.push_back({box.size, box.centre});
    return {BoxUnion(shapes, surface, beyond), ""};
  }
  BoxFit wanted;
  if (setup.count) wanted.most = *setup.count;
  if (setup.gain) wanted.gain = *setup.gain;
  return {BoxUnion(fit_boxes(surface, wanted)), "boxes fitted to the surface"};
}

ImpactorBounds made(const CylinderSectorsBoundsSetup& setup, const Surface& surface, Beyond beyond) {
  const KnownSectors known{.axis = setup.axis,
                           .point = setup.point,
                           .radius = setup.radius,
                           .length = setup.length,
                           .hub_radius = setup.hub_radius,
                           .blades = setup.blades,
                           .sector_angle = setup.sector_angle,
                           .start_angle = setup.start_angle};
  std::vector<std::string> fitted;
  const auto note = [&](bool given, const char* name) {
    if (!given) fitted.push_back(name);
  };
  note(setup.axis.has_value(), "axis");
  note(setup.point.has_value(), "point");
  note(setup.radius.has_value(), "radius");
  note(setup.length.has_value(), "length");
  note(setup.hub_radius.has_value(), "hub_radius");
  note(setup.blades.has_value(), "blades");
  note(setup.sector_angle.has_value(), "sector_angle");
  note(setup.start_angle.has_value(), "start_angle");
  const CylinderSectors region(fit_sectors(surface, known), surface, beyond);
  if (fitted.empty()) return {region, ""};
  std::string words = fmt::format("{} fitted to the surface", fmt::join(fitted, ", "));
  if (!region.shape().has_gaps()) words += "; the angular gaps between its blades are negligible, so that the fan is the whole cylinder";
  return {region, words};
}

ImpactorBounds made(const AutoBoundsSetup&, const Surface& surface, Beyond) {
  FittedBounds fitted = fit_contact_bounds(surface);
  return {std::move(fitted.region), std::move(fitted.choice)};
}

}  // namespace

ImpactorBounds contact_bounds_of(const ContactBoundsSetup& setup, const Surface& surface, const std::string& impactor) {
  try {
    return std::visit([&](const auto& shape) { return made(shape, surface, setup.on_exceed.as<Beyond>()); }, setup.shape);
  } catch (const InputError& error) {
    throw SetupError("impactors." + impactor + ".contact_bounds", error);
  }
}

}  // namespace perimpact
