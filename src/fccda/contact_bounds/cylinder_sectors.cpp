#include "fccda/contact_bounds/cylinder_sectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "base/finite.hpp"

namespace fccda {

namespace {

constexpr double turn = 2 * std::numbers::pi;

Flat flat(const Vec3d& place) { return {place.x, place.y}; }

/// Distance of a segment from the origin.
double nearest_to_origin(const Flat& a, const Flat& b) {
  const Flat along{b.x - a.x, b.y - a.y};
  const double squared = dot(along, along);
  const double share = squared > 0 ? std::clamp(-dot(a, along) / squared, 0.0, 1.0) : 0.0;
  return norm(Flat{a.x + share * along.x, a.y + share * along.y});
}

struct Halves {
  std::array<Vec3d, 3> one, other;
  double longest;  // [m] edge before halving
};

/// Bisects across the longest edge.
Halves halves(const std::array<Vec3d, 3>& corners) {
  std::size_t first = 0;
  double longest = -1;
  for (std::size_t e = 0; e < 3; ++e)
    if (const double length = norm(corners[(e + 1) % 3] - corners[e]); length > longest) longest = length, first = e;
  const Vec3d &a = corners[first], &b = corners[(first + 1) % 3], &c = corners[(first + 2) % 3];
  const Vec3d middle = 0.5 * (a + b);
  return {{a, middle, c}, {middle, b, c}, longest};
}

constexpr int most_blades = 1000;

/// With other numbers the halving of triangles would not end, and queries would reject everything without a message.
void expect_usable(const CylinderSectors::Shape& shape) {
  const auto refuse = [](const std::string& what, const std::string& found, const std::string& must) {
    throw InputError("contact bounds: " + what + " of the cylinder's sectors is " + found + ", but it must " + must + "; correct it.");
  };
  const auto expect = [&](bool holds, const std::string& what, double found, const std::string& unit, const std::string& must) {
    if (!holds || !std::isfinite(found)) refuse(what, in_words(found) + unit, must);
  };
  const double length_of_axis = norm(shape.axis);
  if (!(length_of_axis > 0) || !std::isfinite(length_of_axis)) refuse("the axis", in_words(shape.axis), "have a direction and a finite length");
  if (!is_finite(shape.point)) refuse("the centre", in_words(shape.point) + " m", "be finite");
  expect(shape.radius > 0, "the radius", shape.radius, " m", "be finite and positive");
  expect(shape.length >= 0, "the length", shape.length, " m", "be finite and not negative");
  expect(shape.hub_radius >= 0, "the radius of the hub", shape.hub_radius, " m", "be finite and not negative");
  if (shape.blades < 1 || shape.blades > most_blades) refuse("the number", std::to_string(shape.blades), "be from 1 to " + std::to_string(most_blades));
  // A fitted angle may exceed a turn by rounding.
  expect(shape.sector_angle >= 0 && shape.sector_angle <= turn * (1 + 1e-9), "the angle", shape.sector_angle, " rad", "be from 0 to 2 pi");
  expect(true, "the begin", shape.start_angle, " rad", "be finite");
}

}  // namespace

bool CylinderSectors::Shape::has_gaps() const {
  // A billionth of a turn of tolerance: sectors meant to cover the circle may fall short by rounding.
  return hub_radius < radius && sector_angle < 0.5 * turn && blades * sector_angle < turn * (1 - 1e-9);
}

double CylinderSectors::volume_of(const Shape& shape) {
  const double outer = shape.radius * shape.radius, inner = shape.hub_radius * shape.hub_radius;
  if (!shape.has_gaps()) return 0.5 * turn * outer * shape.length;
  return shape.length * (0.5 * turn * inner + 0.5 * shape.blades * shape.sector_angle * (outer - inner));
}

CylinderSectors::CylinderSectors(const Shape& shape, const Surface& surface, Beyond beyond) : shape_(shape), frame_(shape.point, shape.axis) {
  expect_usable(shape);
  widening_ = widening(surface);
  radius_ = shape.radius + widening_;
  half_length_ = 0.5 * shape.length + widening_;
  slack_ = 1e-3 * shape.radius;
  hub_ = shape.has_gaps() ? shape.hub_radius : shape.radius;
  if (shape.has_gaps())
    for (int blade = 0; blade < shape.blades; ++blade) sectors_.emplace_back(shape.start_angle + turn * blade / shape.blades, shape.sector_angle);

  ExceedingPanels out;
  bool is_reached = false;
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    Corners corners;
    for (std::size_t c = 0; c < 3; ++c) corners[c] = frame_.to_frame(surface.corner(t, c));
    if (is_in_fan(corners)) {
      is_reached = true;
      continue;
    }
    is_reached = is_reached || reaches_in(corners);
    for (const Vec3d& place : {corners[0], corners[1], corners[2], (corners[0] + corners[1] + corners[2]) / 3.0})
      out.add(surface.triangles()[t].panel, distance_in_frame(place, 0));
  }
  if (!is_reached)
    throw InputError(
        "contact bounds: no panel of the surface reaches into the cylinder's sectors, so no contact is possible; check their axis, point and sizes.");
  clips_ = !out.panels.empty();
  if (clips_ && beyond == Beyond::error)
    refuse(out, surface, "the cylinder's sectors", "enlarge radius, length, hub_radius or sector_angle, or omit them to have them fitted");
}

bool CylinderSectors::contains_in_frame(const Vec3d& place, double slack) const {
  const Flat p = flat(place);
  const double r = norm(p);
  if (std::fabs(place.z) > half_length_ || r > radius_) return false;
  return r <= hub_ + slack || std::any_of(sectors_.begin(), sectors_.end(), [&](const Wedge& sector) { return sector.contains(p, slack); });
}

bool CylinderSectors::contains(const Vec3d& point) const { return contains_in_frame(frame_.to_frame(point), slack_); }

bool CylinderSectors::may_contact(const Path& path, double margin) const {
  const Vec3d start = frame_.to_frame(path.start), end = frame_.to_frame(path.end);
  const double height = half_length_ + margin;
  if ((start.z > height && end.z > height) || (start.z < -height && end.z < -height)) return false;
  const Flat a = flat(start), b = flat(end);
  const double nearest = nearest_to_origin(a, b);
  if (nearest > radius_ + margin) return false;
  const double wide = margin + slack_;
  if (!(nearest > hub_ + wide)) return true;
  return std::any_of(sectors_.begin(), sectors_.end(), [&](const Wedge& sector) { return !sector.is_parted_from(a, b, wide); });
}

double CylinderSectors::distance_at_least(const Vec3d& point) const { return distance_in_frame(frame_.to_frame(point), slack_); }

double CylinderSectors::distance_in_frame(const Vec3d& place, double slack) const {
  const Flat p = flat(place);
  const double r = norm(p), above = std::max(std::fabs(place.z) - half_length_, 0.0);
  double from_fan = r - hub_;
  for (const Wedge& sector : sectors_) from_fan = std::min(from_fan, sector.distance(p));
  const double aside = std::max({from_fan - slack, r - radius_, 0.0});
  return std::sqrt(above * above + aside * aside);
}

bool CylinderSectors::is_in_one_part(const Corners& corners) const {
  const auto all = [&](const auto& condition) { return condition(flat(corners[0])) && condition(flat(corners[1])) && condition(flat(corners[2])); };
  return all([&](const Flat& p) { return norm(p) <= hub_ + widening_; }) ||
         std::any_of(sectors_.begin(), sectors_.end(), [&](const Wedge& sector) { return all([&](const Flat& p) { return sector.contains(p, widening_); }); });
}

bool CylinderSectors::is_in_fan(const Corners& corners) const {
  for (const Vec3d& place : corners)
    if (!contains_in_frame(place, widening_)) return false;
  if (is_in_one_part(corners)) return true;
  const Halves two = halves(corners);
  return two.longest < slack_ || (is_in_fan(two.one) && is_in_fan(two.other));
}

// True if a triangle reaches into the bounds: it is halved until a corner is inside.
bool CylinderSectors::reaches_in(const Corners& corners) const {
  for (const Vec3d& place : corners)
    if (contains_in_frame(place, slack_)) return true;
  const Halves two = halves(corners);
  const Vec3d middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  // no corner is farther from the middle than the longest edge
  if (two.longest < slack_ || distance_in_frame(middle, 0) > two.longest) return false;
  return reaches_in(two.one) || reaches_in(two.other);
}

}  // namespace fccda
