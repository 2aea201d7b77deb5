#include "marine/propeller.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "base/contract.hpp"
#include "marine/wageningen.hpp"
#include "mesh/part_naming.hpp"
#include "mesh/shapes/divisions.hpp"
#include "mesh/shapes/halve_edges.hpp"
#include "mesh/shapes/refuse.hpp"
#include "mesh/shapes/rings.hpp"
#include "mesh/shapes/strip.hpp"

namespace fccda {
namespace {

constexpr double growth = 0.3;        // of edges with the distance from the outline
constexpr double root_in_hub = 0.83;  // of the hub's radius: deep enough for any hub of 12 sides or more, cos(π/12) = 0.97
constexpr double pi = std::numbers::pi;

template <class... Words>
[[noreturn]] void refuse(const Words&... words) {
  refuse_shape("propeller", words...);
}

void check_list(const std::vector<double>& list, const PropellerSections& sections, const char* name, bool may_be_empty) {
  if (list.empty() && may_be_empty) return;
  if (list.size() != sections.radius.size())
    refuse("sections.", name, " has ", list.size(), " numbers, but sections.radius has ", sections.radius.size(), "; give one for each radius.");
}

void check_sections(const PropellerSections& sections, double hub_ratio) {
  const std::vector<double>& radius = sections.radius;
  if (radius.size() < 2) refuse("sections.radius needs two radii at least, such as [0.2, 1].");
  for (std::size_t k = 0; k + 1 < radius.size(); ++k) {
    if (radius[k + 1] <= radius[k])
      refuse("sections.radius goes from ", radius[k], " to ", radius[k + 1], ", but each radius must be greater than the one before.");
  }
  if (radius.back() != 1) refuse("sections.radius ends at ", radius.back(), ", but the tip is at 1; radii are r/R.");
  if (radius.front() > hub_ratio * (1 + 1e-9))
    refuse("sections.radius begins at ", radius.front(), ", outside the hub of hub_ratio ", hub_ratio, "; give a section at the hub's radius or within.");
  check_list(sections.chord, sections, "chord", false);
  check_list(sections.thickness, sections, "thickness", false);
  check_list(sections.pitch, sections, "pitch", false);
  check_list(sections.rake, sections, "rake", true);
  check_list(sections.skew, sections, "skew", true);
  check_list(sections.camber, sections, "camber", true);
  for (std::size_t k = 0; k < radius.size(); ++k) {
    const bool is_tip = k + 1 == radius.size();
    if (sections.chord[k] < 0 || (sections.chord[k] == 0 && !is_tip))
      refuse("sections.chord is ", sections.chord[k], " at r/R ", radius[k], ", but only the tip may have none.");
    if (sections.thickness[k] <= 0) refuse("sections.thickness is ", sections.thickness[k], " at r/R ", radius[k], ", but it must be above 0.");
  }
}

/// The developed outline of a blade, triangulated: coordinates `along` the chord and `out` from the root (0) to the tip (1).
class Sheet {
 public:
  Sheet(const BladeForm& form, double panel, double blade_edge_length)
      : form_(form), panel_(panel), blade_edge_length_(blade_edge_length), is_pointed_(form.section(form.tip_radius()).chord == 0) {
    // outward from the root in steps that decrease as the outline turns inward
    const double span = form.tip_radius() - form.root_radius();
    const int stations = static_cast<int>(divisions(1.5 * span, panel)) + 1;
    std::vector<int> inner = add_station(0);
    for (int k = 1; k <= stations; ++k) {
      const std::vector<int> outer = add_station(double(k) / stations);
      fill_strip(
          inner, outer, [&](int v) { return 0.5 * (face_[index(v)] + back_[index(v)]); },
          [&](int a, int b, int c) {
            triangles_.push_back({a, b, c});
          });
      inner = outer;
    }
    halve_edges(triangles_, {.excess = [&](int a, int b) { return length(a, b) / size_between(a, b); },
                             .length = [&](int a, int b) { return length(a, b); },
                             .middle = [&](int a, int b) { return add(middle(a, b)); }});
  }

  /// The blade as a closed surface: back, face, and the band between them around outline and root.
  Panels closed() const {
    Panels out;
    out.vertices = back_;
    out.vertices.insert(out.vertices.end(), face_.begin(), face_.end());
    const int beneath = static_cast<int>(back_.size());
    std::set<std::pair<int, int>> open;  // edges of the back that no adjacent triangle has traversed in the other direction
    for (const auto& t : triangles_) {
      out.add_triangle(t[0], t[1], t[2]);
      out.add_triangle(beneath + t[0], beneath + t[2], beneath + t[1]);
      for (std::size_t e = 0; e < 3; ++e) {
        const int a = t[e], b = t[(e + 1) % 3];
        if (open.erase({b, a}) == 0) open.insert({a, b});
      }
    }
    for (const auto& edge : open) {
      const int a = edge.first, b = edge.second;
      out.add_triangle(b, a, beneath + a);
      out.add_triangle(b, beneath + a, beneath + b);
    }
    return out;
  }

 private:
  struct Place {
    double along, out;
  };

  static std::size_t index(int v) { return static_cast<std::size_t>(v); }

  /// Steps of `out` decrease towards the tip as a round outline requires.
  double radius(double out) const { return form_.root_radius() + (form_.tip_radius() - form_.root_radius()) * out * (2 - out); }

  int add(const Place& place) {
    const BladeForm::Section section = form_.section(radius(place.out));
    places_.push_back(place);
    face_.push_back(form_.place(section, place.along, 0));
    back_.push_back(form_.place(section, place.along, 1));
    return static_cast<int>(places_.size()) - 1;
  }

  std::vector<int> add_station(double out) {
    const double chord = form_.section(radius(out)).chord;
    const int parts = chord > 0 ? static_cast<int>(divisions(chord, panel_)) : 0;
    std::vector<int> station;
    for (int k = 0; k <= parts; ++k) station.push_back(add({parts == 0 ? 0 : -1 + 2.0 * k / parts, out}));
    return station;
  }

  /// A pointed tip has no position along the chord: edges to it take that of the other end.
  Place middle(int a, int b) const {
    const Place &p = places_[index(a)], &q = places_[index(b)];
    const bool is_p_point = p.out == 1 && is_pointed_, is_q_point = q.out == 1 && is_pointed_;
    const double along = is_p_point ? q.along : is_q_point ? p.along : 0.5 * (p.along + q.along);
    return {along, 0.5 * (p.out + q.out)};
  }

  double length(int a, int b) const { return std::fmax(norm(face_[index(a)] - face_[index(b)]), norm(back_[index(a)] - back_[index(b)])); }

  double size_between(int a, int b) const {
    const Place at = middle(a, b);
    const double r = radius(at.out), to_edge = 0.5 * (1 - std::fabs(at.along)) * form_.section(r).chord, to_tip = form_.tip_radius() - r;
    return std::fmin(panel_, blade_edge_length_ + growth * std::fmin(to_edge, to_tip));
  }

  const BladeForm& form_;
  double panel_, blade_edge_length_;
  bool is_pointed_;
  std::vector<Place> places_;
  std::vector<Vec3d> face_, back_;
  std::vector<std::array<int, 3>> triangles_;
};

void add_hub(Panels& out, const HubForm& hub, double panel) {
  const double rounding = hub.rounding(), flat = hub.radius - rounding, half = 0.5 * hub.length;
  std::vector<std::pair<double, double>> profile;  // z, radius, upward
  const int arcs = static_cast<int>(divisions(0.5 * pi * rounding, panel)), rows = static_cast<int>(divisions(hub.length - 2 * rounding, panel));
  for (int k = 0; k <= arcs; ++k) {
    const double angle = 0.5 * pi * k / arcs;
    profile.push_back({-half + rounding * (1 - std::cos(angle)), flat + rounding * std::sin(angle)});
  }
  const auto lower = profile;
  for (int row = 1; row < rows; ++row) profile.push_back({(half - rounding) * (static_cast<double>(2 * row - rows) / rows), hub.radius});
  for (auto point = lower.rbegin(); point != lower.rend(); ++point) profile.push_back({-point->first, point->second});

  const auto ring_at = [&](const std::pair<double, double>& point) {
    return add_ring(out, static_cast<int>(circle_divisions(point.second, panel)), point.second, point.first);
  };
  Ring below = ring_at(profile.front());
  add_cap(out, below, flat, -half, panel, Facing::down);
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const Ring above = ring_at(profile[k]);
    zip_rings(out, above, below, Facing::up);
    below = above;
  }
  add_cap(out, below, flat, half, panel, Facing::up);
}

/// The root must end inside the hub, whose sides are chords.
void check_root(const BladeForm& form, const HubForm& hub, double panel) {
  const BladeForm::Section root = form.section(form.root_radius());
  const double chords = std::cos(pi / circle_divisions(hub.radius, panel));
  constexpr int samples = 40;
  double furthest = 0;
  bool extends_beyond = false;
  for (int k = 0; k <= samples; ++k) {
    for (const double through : {0.0, 1.0}) {
      const double z = form.place(root, -1 + 2.0 * k / samples, through).z;
      furthest = std::fmax(furthest, std::fabs(z));
      extends_beyond = extends_beyond || hub.radius_at(z) * chords <= form.root_radius();
    }
  }
  if (extends_beyond)
    refuse("the roots of the blades reach ", furthest, " m along the shaft from the middle of the hub, beyond its ends; hub_length is ", hub.length, " m, use ",
           2 * (furthest + HubForm{hub.radius, 1e300}.rounding()), " m or more.");
}

void append(Panels& all, const Panels& one, double angle) {
  const int before = static_cast<int>(all.vertices.size());
  const double c = std::cos(angle), s = std::sin(angle);
  for (const Vec3d& v : one.vertices) all.vertices.push_back({c * v.x - s * v.y, s * v.x + c * v.y, v.z});
  for (const auto& p : one.panels) all.add_triangle(before + p[0], before + p[1], before + p[2]);
}

std::vector<MonotoneCubic> curve(const std::vector<double>& radius, const std::vector<double>& values) {
  if (values.empty()) return {};
  return {MonotoneCubic(radius, values)};
}

}  // namespace

BladeForm::BladeForm(const PropellerShape& shape) : shape_(shape), root_(root_in_hub * 0.5 * shape.hub_ratio * shape.diameter) {
  EXPECTS(shape.blades >= 1 && shape.diameter > 0 && shape.hub_ratio > 0 && shape.hub_ratio < 1 && shape.hub_length > 0);
  EXPECTS(shape.thickness_factor > 0 && shape.edge_thickness > 0 && shape.edge_thickness < 1 && shape.edge_length > 0 && shape.blade_edge_length >= 0);
  if (shape.blade_edge_length > shape.edge_length)
    refuse("blade_edge_length is ", shape.blade_edge_length, " m, but edges are made finer, not coarser, than edge_length, ", shape.edge_length, " m.");
  if (!shape.sections) {
    EXPECTS(shape.pitch_ratio > 0 && shape.area_ratio > 0);
    if (shape.blades < wageningen::fewest_blades || shape.blades > wageningen::most_blades)
      refuse("the tables of the Wageningen B-series are for ", wageningen::fewest_blades, " to ", wageningen::most_blades, " blades, not ", shape.blades,
             "; specify `sections` for others.");
    return;
  }
  check_sections(*shape.sections, shape.hub_ratio);
  const PropellerSections& own = *shape.sections;
  std::vector<double> squared = own.chord;
  for (double& chord : squared) chord *= chord;
  chord_squared_ = curve(own.radius, squared);
  thickness_ = curve(own.radius, own.thickness);
  pitch_ = curve(own.radius, own.pitch);
  rake_ = curve(own.radius, own.rake);
  skew_ = curve(own.radius, own.skew);
  camber_ = curve(own.radius, own.camber);
}

BladeForm::Section BladeForm::section(double radius) const {
  const double diameter = shape_.diameter, r = 2 * radius / diameter;
  const bool own = shape_.sections.has_value();
  const double chord = diameter * (own ? std::sqrt(std::fmax(0.0, chord_squared_[0](r))) : wageningen::chord(r, shape_.blades, shape_.area_ratio));
  const double thickness = shape_.thickness_factor * diameter * (own ? thickness_[0](r) : wageningen::thickness(r, shape_.blades));
  const double pitch = diameter * (own ? pitch_[0](r) : shape_.pitch_ratio * wageningen::pitch(r, shape_.blades));
  const bool own_skew = !skew_.empty();
  const double into_tip = std::fmin(1, (tip_radius() - radius) / (3 * thickness));
  const double beyond_hub = std::fmax(0.0, (r - shape_.hub_ratio) / (1 - shape_.hub_ratio));
  return {.radius = radius,
          .chord = chord,
          .leading = chord * (own_skew ? 0.5 : wageningen::leading_part(r)),
          .thickest = chord * wageningen::thickest(r),
          .thickness = thickness,
          .edge_thickness = shape_.edge_thickness * thickness,
          .bulge = (1 - shape_.edge_thickness) * thickness * into_tip * (2 - into_tip),
          .pitch_angle = std::atan(pitch / (2 * pi * radius)),
          .rake = rake_.empty() ? radius * std::tan(shape_.rake) : diameter * rake_[0](r),
          .skew = own_skew ? skew_[0](r) : shape_.skew * beyond_hub * beyond_hub};
}

Vec3d BladeForm::place(const Section& section, double along, double through) const {
  const double r = section.radius / tip_radius();
  const double s = section.leading - 0.5 * (1 - along) * section.chord;
  double y = through * section.edge_thickness;
  if (section.chord > 0) {
    const double crest = section.leading - section.thickest;
    const double behind = section.chord - section.thickest;
    const double place = std::clamp(s >= crest ? (s - crest) / section.thickest : (s - crest) / behind, -1.0, 1.0);
    const double between = wageningen::rise(r, place) * section.bulge + section.edge_thickness;
    const double face = camber_.empty() ? wageningen::face(r, place) * section.bulge : camber_[0](r) * section.chord * (1 - along * along) - 0.5 * between;
    y = face + through * between;
  }
  const double c = std::cos(section.pitch_angle), sine = std::sin(section.pitch_angle);
  const double on_helix = s - section.skew * section.radius / c;
  const double angle = (on_helix * c - y * sine) / section.radius;
  return {section.radius * std::cos(angle), section.radius * std::sin(angle), on_helix * sine + y * c - section.rake};
}

double BladeForm::expanded_area_ratio(double from) const {
  // Simpson's rule over w, r = R - (R - r0)(1 - w)², which removes the square-root singularity at a round tip
  constexpr int pieces = 2000;
  const double inner = from * tip_radius(), span = tip_radius() - inner;
  double sum = 0;
  for (int k = 0; k <= pieces; ++k) {
    const double rest = 1 - double(k) / pieces, weight = k == 0 || k == pieces ? 1 : k % 2 ? 4 : 2;
    sum += weight * section(tip_radius() - span * rest * rest).chord * 2 * span * rest;
  }
  return shape_.blades * sum / (3 * pieces) / (pi * tip_radius() * tip_radius());
}

double HubForm::rounding() const { return std::fmin(0.3 * radius, 0.25 * length); }

double HubForm::radius_at(double z) const {
  const double into_rim = std::fabs(z) - (0.5 * length - rounding());
  if (into_rim <= 0) return radius;
  if (into_rim > rounding()) return 0;
  return radius - rounding() + std::sqrt(rounding() * rounding() - into_rim * into_rim);
}

Panels make_propeller(const PropellerShape& shape) {
  const BladeForm form(shape);
  const HubForm hub{.radius = 0.5 * shape.hub_ratio * shape.diameter, .length = shape.hub_length};
  const double hub_panel = std::fmin(shape.edge_length, 0.5 * hub.radius),
               blade_edge_length = shape.blade_edge_length > 0 ? shape.blade_edge_length : shape.edge_length;
  check_root(form, hub, hub_panel);
  // two triangles per square of panels on both sides, and bands of blade_edge_length with their gradual growth along the outlines; bisection at
  // most doubles the number
  const double area = form.expanded_area_ratio(root_in_hub * shape.hub_ratio) * pi * form.tip_radius() * form.tip_radius();
  const double outline = shape.blades * 3 * form.tip_radius();
  const double graded = outline / growth * (1 / blade_edge_length - 1 / shape.edge_length) + outline / blade_edge_length;
  expect_affordable(8 * (area / (shape.edge_length * shape.edge_length) + graded), blade_edge_length, "propeller");
  expect_affordable(4 * pi * hub.radius * (hub.length + hub.radius) / (hub_panel * hub_panel), hub_panel, "propeller's hub");

  Panels out;
  PartNaming parts(out);
  parts.begin("hub");
  add_hub(out, hub, hub_panel);
  const Panels blade = Sheet(form, shape.edge_length, blade_edge_length).closed();
  for (int k = 0; k < shape.blades; ++k) {
    parts.begin("blade_" + std::to_string(k + 1));
    append(out, blade, 2 * pi * k / shape.blades);
  }
  parts.finish();
  if (shape.hand == Hand::left) {
    for (Vec3d& v : out.vertices) v.y = -v.y;
    for (auto& p : out.panels) std::swap(p[1], p[2]);
  }
  turn_axis(out, shape.axis);
  return out;
}

}  // namespace fccda
