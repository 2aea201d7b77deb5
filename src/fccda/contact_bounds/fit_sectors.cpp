#include "fccda/contact_bounds/fit_sectors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/contract.hpp"
#include "fccda/contact_bounds/angular_occupancy.hpp"
#include "fccda/contact_bounds/principal_axes.hpp"

namespace fccda {

namespace {

constexpr double turn = 2 * std::numbers::pi;

CylinderSectors::Shape fit_about(const Vec3d& axis, const Vec3d& centroid, const Surface& surface, const KnownSectors& known) {
  const Vec3d on_axis = known.point.value_or(centroid);
  const AngularOccupancy taken(surface, CylinderFrame(on_axis, axis));
  const double middle = known.point ? 0 : 0.5 * (taken.low() + taken.high());
  CylinderSectors::Shape shape{.axis = normalised(axis),
                               .point = on_axis + middle * normalised(axis),
                               .radius = known.radius.value_or(taken.radius()),
                               .length = known.length.value_or(2 * std::max(taken.high() - middle, middle - taken.low()))};
  const SectorFan fan = taken.smallest_fan(known.hub_radius, known.blades);
  shape.hub_radius = fan.hub_radius, shape.blades = fan.blades, shape.sector_angle = fan.sector_angle, shape.start_angle = fan.start_angle;
  if (known.sector_angle) {
    shape.sector_angle = *known.sector_angle;
    shape.start_angle = known.start_angle.value_or(fan.start_angle + 0.5 * (fan.sector_angle - *known.sector_angle));
    return shape;
  }
  CylinderSectors::Shape whole = shape;
  whole.hub_radius = whole.radius, whole.sector_angle = turn / whole.blades, whole.start_angle = 0;
  constexpr double worth_having = 0.01;
  if (CylinderSectors::volume_of(shape) < (1 - worth_having) * CylinderSectors::volume_of(whole)) return shape;
  if (known.hub_radius) whole.hub_radius = *known.hub_radius;
  return whole;
}

}  // namespace

CylinderSectors::Shape fit_sectors(const Surface& surface, const KnownSectors& known) {
  EXPECTS(known.sector_angle || !known.start_angle);
  const AreaAxes axes = area_axes(surface);
  if (known.axis) return fit_about(*known.axis, axes.centroid, surface, known);
  CylinderSectors::Shape best = fit_about(axes.direction[0], axes.centroid, surface, known);
  for (const Vec3d& axis : {axes.direction[1], axes.direction[2]}) {
    const CylinderSectors::Shape other = fit_about(axis, axes.centroid, surface, known);
    if (CylinderSectors::volume_of(other) < CylinderSectors::volume_of(best)) best = other;
  }
  return best;
}

}  // namespace fccda
