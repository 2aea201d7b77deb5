#include "perimpact/contact_bounds/cylinder_sectors/setup.hpp"

#include <fmt/format.h>

#include <numbers>

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<CylinderSectorsBoundsSetup>> CylinderSectorsBoundsSetup::fields() {
  using S = CylinderSectorsBoundsSetup;
  static const Field<S> all[] = {
      {"axis", &S::axis, "1", any_number(), optional, "Direction of the axis in the surface's axes. Where absent, fitted, as are all keys here."},
      {"point", &S::point, "m", any_number(), optional, "Centre of the cylinder, relative to the surface's origin."},
      {"radius", &S::radius, "m", positive(), optional, "Radius of the cylinder."},
      {"length", &S::length, "m", positive(), optional, "Length of the cylinder."},
      {"hub_radius", &S::hub_radius, "m", at_least(0), optional, "Radius within which there are no gaps between sectors."},
      {"blades", &S::blades, "1", between(1, 1000), optional, "Number of equally spaced sectors."},
      {"sector_angle", &S::sector_angle, "rad", between(0, 2 * std::numbers::pi), optional, "Width of each sector. Half a turn or more: no gaps."},
      {"start_angle", &S::start_angle, "rad", any_number(), optional,
       "Start of the first sector: about the axis z from x towards y, about x from y towards z, about y from z towards x. Requires sector_angle."}};
  return all;
}

void CylinderSectorsBoundsSetup::check(const DeckContext& deck) const {
  if (axis && *axis == Vec3d{}) deck.refuse("axis", "axis is [0, 0, 0], which has no direction; give one, such as [0, 0, 1], or omit it to have it fitted.");
  if (start_angle && !sector_angle) deck.refuse("start_angle", "start_angle is given without sector_angle; give both, or omit both to have them fitted.");
  if (radius && hub_radius && *hub_radius > *radius)
    deck.refuse("hub_radius", fmt::format("hub_radius is {} m, but the radius of the cylinder is {} m; reduce hub_radius.", *hub_radius, *radius));
}

}  // namespace perimpact
