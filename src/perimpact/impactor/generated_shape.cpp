#include "perimpact/impactor/generated_shape.hpp"

#include "base/error.hpp"

namespace perimpact {

fccda::HullShape shape_of(const HullSurface& s) {
  fccda::HullShape shape{.length = s.length,
                         .breadth = s.breadth,
                         .draft = s.draft,
                         .freeboard = s.freeboard.value_or(2 * s.draft / 3),
                         .stem_angle = s.stem_angle,
                         .waterline_angle = s.waterline_angle,
                         .fullness = s.fullness,
                         .bilge_radius = s.bilge_radius.value_or(s.draft / 3),
                         .stem_radius = s.stem_radius.value_or(0),
                         .flare = s.flare,
                         .edge_length = s.edge_length,
                         .bow_edge_length = s.bow_edge_length.value_or(s.edge_length)};
  if (s.stern_angle) shape.stern_angle = *s.stern_angle;
  if (s.stern_waterline_angle) shape.stern_waterline_angle = *s.stern_waterline_angle;
  return shape;
}

fccda::PropellerShape shape_of(const PropellerSurface& s) {
  if (!s.sections && !s.pitch_ratio)
    throw fccda::InputError("propeller: pitch_ratio is missing; give it, such as pitch_ratio: 0.76, or user-defined sections.");
  if (!s.sections && !s.area_ratio) throw fccda::InputError("propeller: area_ratio is missing; give it, such as area_ratio: 0.669, or user-defined sections.");
  if (s.sections && s.pitch_ratio)
    throw fccda::InputError("propeller: pitch_ratio is given, but sections.pitch defines it for each radius; remove pitch_ratio.");
  if (s.sections && s.area_ratio) throw fccda::InputError("propeller: area_ratio is given, but follows from sections.chord; remove area_ratio.");
  fccda::PropellerShape shape{.blades = s.blades,
                              .diameter = s.diameter,
                              .pitch_ratio = s.pitch_ratio.value_or(0),
                              .area_ratio = s.area_ratio.value_or(0),
                              .hub_ratio = s.hub_ratio,
                              .hub_length = s.hub_length.value_or(0.3 * s.diameter),
                              .rake = s.rake,
                              .skew = s.skew,
                              .thickness_factor = s.thickness_factor,
                              .edge_thickness = s.edge_thickness,
                              .hand = s.hand.as<fccda::Hand, hand_words>(),
                              .axis = s.axis.as<fccda::Axis, axis_words>(),
                              .sections = {},
                              .edge_length = s.edge_length,
                              .blade_edge_length = s.blade_edge_length.value_or(s.edge_length)};
  if (s.sections) {
    const PropellerSectionsSetup& own = *s.sections;
    shape.sections = fccda::PropellerSections{own.radius, own.chord, own.thickness, own.pitch, own.rake, own.skew, own.camber};
  }
  return shape;
}

}  // namespace perimpact
