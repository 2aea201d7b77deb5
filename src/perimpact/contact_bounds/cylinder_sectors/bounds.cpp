#include "perimpact/contact_bounds/cylinder_sectors/bounds.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "fccda/contact_bounds/fit_sectors.hpp"

namespace perimpact {

using namespace fccda;

ImpactorBounds make_bounds(const CylinderSectorsBoundsSetup& setup, const Surface& surface, Beyond beyond) {
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

}  // namespace perimpact
