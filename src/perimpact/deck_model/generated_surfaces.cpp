#include "perimpact/deck_model/generated_surfaces.hpp"

#include <numbers>

namespace perimpact {

using fccda::any_number;
using fccda::at_least;
using fccda::between;
using fccda::positive;
using fccda::Presence;
using fccda::Range;
using fccda::strictly_between;

namespace {

constexpr auto required = Presence::required, optional = Presence::optional;

/// Up to 90 deg, of which rounding may make somewhat more.
constexpr Range up_to_upright() { return {.low = 0, .high = 1.5708, .low_included = false}; }

}  // namespace

std::span<const Field<HullSurface>> HullSurface::fields() {
  using S = HullSurface;
  static const Field<S> all[] = {
      {"length", &S::length, "m", positive(), required, "Length of the waterline L, from stem to stern."},
      {"breadth", &S::breadth, "m", positive(), required, "Breadth B on the waterline."},
      {"draft", &S::draft, "m", positive(), required, "Draft T: how deep the flat bottom lies below the waterline."},
      {"stem_angle", &S::stem_angle, "rad", up_to_upright(), required,
       "Stem angle φ between the straight stem and the waterline: 24 deg. 90 deg is upright. Without flare the normals of the whole bow have n_x/n_z = tan φ."},
      {"waterline_angle", &S::waterline_angle, "rad", strictly_between(0, 1.57), required,
       "Half angle of entrance α between waterline and centreline at the stem: 22 deg."},
      {"fullness", &S::fullness, "1", between(1, 4), optional,
       "Power p of the bow's waterlines, 1 - (1 - t)^p of the half-breadth: 1 is a wedge, more is rounder and longer. The bow is p B/2 / tan α long."},
      {"bilge_radius", &S::bilge_radius, "m", at_least(0), optional,
       "Radius R of the bilge between side and bottom, at most the draft; 0 is a sharp edge. Where absent, a third of the draft."},
      {"freeboard", &S::freeboard, "m", positive(), optional, "Height F of the flat deck above the waterline. Where absent, two thirds of the draft."},
      {"stern_angle", &S::stern_angle, "rad", up_to_upright(), optional, "Angle between the straight stern and the waterline. Where absent, 35 deg."},
      {"stern_waterline_angle", &S::stern_waterline_angle, "rad", strictly_between(0, 1.57), optional,
       "Half angle between waterline and centreline at the stern. Where absent, 30 deg."},
      {"flare", &S::flare, "rad", between(-0.5236, 1.0472), optional,
       "Angle of the sides from the vertical, outward as they rise; below 0 they fall inward. With flare the angles of the bow hold on the waterline only."},
      {"edge_length", &S::edge_length, "m", positive(), required, "Edge length of panels. Diagonals reach 1.5 times it."},
      {"bow_edge_length", &S::bow_edge_length, "m", positive(), optional,
       "Edge length of panels in the bow; behind it they grow by a fifth of the distance up to panel. Where absent, panel."}};
  return all;
}

std::span<const Field<PropellerSectionsSetup>> PropellerSectionsSetup::fields() {
  using S = PropellerSectionsSetup;
  static const Field<S> all[] = {
      {"radius", &S::radius, "1", between(0, 1), required, "Radii r/R of the sections, rising from the hub's or less to 1, the tip."},
      {"chord", &S::chord, "1", between(0, 1), required, "Chord over diameter of each section; 0 at a pointed tip."},
      {"thickness", &S::thickness, "1", between(0, 1), required, "Greatest thickness over diameter of each section."},
      {"pitch", &S::pitch, "1", between(0, 10), required, "Pitch over diameter of each section."},
      {"rake", &S::rake, "1", between(-1, 1), optional, "How far aft each section lies, over the diameter. Where absent, by the angle rake."},
      {"skew", &S::skew, "rad", between(-std::numbers::pi, std::numbers::pi), optional,
       "Angle by which the middle of each section's chord lags. Where absent, that of the Wageningen series with the angle skew."},
      {"camber", &S::camber, "1", between(-0.5, 0.5), optional,
       "Height of each section's mean line over its chord, a parabola with half of the thickness to each side. Where absent, the sections of the "
       "Wageningen series."}};
  return all;
}

std::span<const Field<PropellerSurface>> PropellerSurface::fields() {
  using S = PropellerSurface;
  static const Field<S> all[] = {
      {"diameter", &S::diameter, "m", positive(), required, "Diameter D of the circle of the tips."},
      {"blades", &S::blades, "1", between(1, 12), optional, "Number of blades Z. The Wageningen series is built in for 4 to 7, others need sections."},
      {"pitch_ratio", &S::pitch_ratio, "1", strictly_between(0, 10), optional,
       "Pitch over diameter at 0.7 of the radius; with four blades less towards the hub, as in the series. Needed without sections."},
      {"area_ratio", &S::area_ratio, "1", strictly_between(0, 2), optional,
       "Expanded area ratio: area of the blades laid flat over that of the disc, counted from the series' hub, r/R = 0.167. Needed without sections."},
      {"hub_ratio", &S::hub_ratio, "1", between(0.1, 0.6), optional, "Diameter of the hub over that of the propeller. The blades begin at 0.83 of its radius."},
      {"hub_length", &S::hub_length, "m", positive(), optional, "Length of the hub, its rims rounded. Where absent, 0.3 of the diameter."},
      {"rake", &S::rake, "rad", between(-0.7854, 0.7854), optional, "Angle by which the blades lean aft: 15 deg in the series as published."},
      {"skew", &S::skew, "rad", between(-1.5708, 1.5708), optional,
       "Angle by which the tip lags behind the root along its helix, beside what the series has; it grows with the square of the distance from the hub."},
      {"thickness_factor", &S::thickness_factor, "1", between(0.1, 5), optional,
       "Multiplies all thicknesses; blades for ice are thicker than those of the series."},
      {"edge_thickness", &S::edge_thickness, "1", between(0.01, 0.5), optional, "Thickness of edges and tip over the greatest one of the section."},
      {"hand",
       &S::hand,
       "",
       {},
       optional,
       "right or left. A right-handed propeller goes ahead, along its positive axis, while it turns about it by the right-hand rule."},
      {"axis", &S::axis, "", {}, optional, "Direction of the shaft, forward: x, y or z."},
      {"edge_length", &S::edge_length, "m", positive(), required, "Longest edge of panels; diagonals on the hub reach 1.41 times it."},
      {"blade_edge_length", &S::blade_edge_length, "m", positive(), optional,
       "Longest edge of panels at leading edge, trailing edge and tip; away from them panels grow by 0.3 of the distance up to panel. Where absent, panel."}};
  return all;
}

}  // namespace perimpact
