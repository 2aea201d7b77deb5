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

/// Up to 90 deg, with a margin for rounding.
constexpr Range up_to_upright() { return {.low = 0, .high = 1.5708, .low_included = false}; }

}  // namespace

std::span<const Field<HullSurface>> HullSurface::fields() {
  using S = HullSurface;
  static const Field<S> all[] = {
      {"length", &S::length, "m", positive(), required, "Length of the waterline L, from stem to stern."},
      {"breadth", &S::breadth, "m", positive(), required, "Breadth B on the waterline."},
      {"draft", &S::draft, "m", positive(), required, "Draft T: depth of the flat bottom below the waterline."},
      {"stem_angle", &S::stem_angle, "rad", up_to_upright(), required,
       "Stem angle φ between the straight stem and the waterline, for example 24 deg; 90 deg is vertical. Without flare the normals of the whole bow have "
       "n_x/n_z = tan φ."},
      {"waterline_angle", &S::waterline_angle, "rad", strictly_between(0, 1.57), required,
       "Half angle of entrance α between waterline and centreline at the stem, for example 22 deg."},
      {"fullness", &S::fullness, "1", between(1, 4), optional,
       "Exponent p of the waterlines of the bow, half-breadth times 1 - (1 - t)^p: 1 is a wedge, larger values are fuller and longer. The bow is p B/2 / tan α "
       "long, less what stem_radius takes."},
      {"bilge_radius", &S::bilge_radius, "m", at_least(0), optional,
       "Bilge radius R between side and bottom, at most the draft; 0 is a sharp edge. Where absent, a third of the draft."},
      {"stem_radius", &S::stem_radius, "m", at_least(0), optional,
       "Radius of the waterlines at the stem, a thousandth to a quarter of the breadth; 0 is a sharp edge. Where absent, 0."},
      {"freeboard", &S::freeboard, "m", positive(), optional, "Height F of the flat deck above the waterline. Where absent, two thirds of the draft."},
      {"stern_angle", &S::stern_angle, "rad", up_to_upright(), optional, "Angle between the straight stern and the waterline. Where absent, 35 deg."},
      {"stern_waterline_angle", &S::stern_waterline_angle, "rad", strictly_between(0, 1.57), optional,
       "Half angle between waterline and centreline at the stern. Where absent, 30 deg."},
      {"flare", &S::flare, "rad", between(-0.5236, 1.0472), optional,
       "Flare angle of the sides from the vertical, positive outward; negative is tumblehome. With flare the angles of the bow apply at the waterline only."},
      {"edge_length", &S::edge_length, "m", positive(), required, "Edge length of the panels; diagonals reach 1.5 times it."},
      {"bow_edge_length", &S::bow_edge_length, "m", positive(), optional,
       "Edge length of the panels of the bow; aft of it they grow by a fifth of the distance, up to edge_length. Where absent, edge_length."}};
  return all;
}

std::span<const Field<PropellerSectionsSetup>> PropellerSectionsSetup::fields() {
  using S = PropellerSectionsSetup;
  static const Field<S> all[] = {
      {"radius", &S::radius, "1", between(0, 1), required, "Radii r/R of the sections, increasing from the hub radius or less to 1, the tip."},
      {"chord", &S::chord, "1", between(0, 1), required, "Chord over diameter of each section; 0 at a pointed tip."},
      {"thickness", &S::thickness, "1", between(0, 1), required, "Maximum thickness over diameter of each section."},
      {"pitch", &S::pitch, "1", between(0, 10), required, "Pitch over diameter of each section."},
      {"rake", &S::rake, "1", between(-1, 1), optional, "Axial position of each section over the diameter, positive aft. Where absent, from the rake angle."},
      {"skew", &S::skew, "rad", between(-std::numbers::pi, std::numbers::pi), optional,
       "Skew angle of each section's mid-chord, positive backward. Where absent, that of the Wageningen series with the key skew."},
      {"camber", &S::camber, "1", between(-0.5, 0.5), optional,
       "Camber of each section over its chord: a parabolic mean line with half of the thickness on each side. Where absent, the sections of the Wageningen "
       "series."}};
  return all;
}

std::span<const Field<PropellerSurface>> PropellerSurface::fields() {
  using S = PropellerSurface;
  static const Field<S> all[] = {
      {"diameter", &S::diameter, "m", positive(), required, "Diameter D of the tip circle."},
      {"blades", &S::blades, "1", between(1, 12), optional,
       "Number of blades Z. The Wageningen series is built in for 4 to 7; other numbers require sections."},
      {"pitch_ratio", &S::pitch_ratio, "1", strictly_between(0, 10), optional,
       "Pitch over diameter at 0.7 R; with four blades reduced towards the hub, as in the series. Required without sections."},
      {"area_ratio", &S::area_ratio, "1", strictly_between(0, 2), optional,
       "Expanded area ratio: expanded area of the blades over that of the disc, counted from the series' hub, r/R = 0.167. Required without sections."},
      {"hub_ratio", &S::hub_ratio, "1", between(0.1, 0.6), optional, "Hub diameter over propeller diameter. The blades begin at 0.83 of the hub radius."},
      {"hub_length", &S::hub_length, "m", positive(), optional, "Length of the hub, with rounded edges. Where absent, 0.3 of the diameter."},
      {"rake", &S::rake, "rad", between(-0.7854, 0.7854), optional, "Rake angle of the blades, positive aft: 15 deg in the published series."},
      {"skew", &S::skew, "rad", between(-1.5708, 1.5708), optional,
       "Skew angle of the tip behind the root along the helix, in addition to that of the series; it grows with the square of the distance from the hub."},
      {"thickness_factor", &S::thickness_factor, "1", between(0.1, 5), optional,
       "Factor on all thicknesses; blades for ice are thicker than those of the series."},
      {"edge_thickness", &S::edge_thickness, "1", between(0.01, 0.5), optional, "Thickness of edges and tip over the maximum thickness of the section."},
      {"hand",
       &S::hand,
       "",
       {},
       optional,
       "right or left. A right-handed propeller advances along its positive axis while it turns about that axis by the right-hand rule."},
      {"axis", &S::axis, "", {}, optional, "Direction of the shaft, forward: x, y or z."},
      {"edge_length", &S::edge_length, "m", positive(), required, "Longest panel edge; diagonals on the hub reach 1.41 times it."},
      {"blade_edge_length", &S::blade_edge_length, "m", positive(), optional,
       "Longest panel edge at leading edge, trailing edge and tip; away from them panels grow by 0.3 of the distance, up to edge_length. Where absent, "
       "edge_length."}};
  return all;
}

}  // namespace perimpact
