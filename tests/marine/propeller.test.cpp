#include "marine/propeller.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "base/error.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "marine/wageningen.hpp"
#include "mesh/inspect/self_intersections.hpp"
#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180;

/// The propeller of Zhang et al., section 6.2, as a Wageningen B4-66.9.
PropellerShape b4(double panel, double blade_edge_length) {
  return {.diameter = 4.12,
          .pitch_ratio = 0.76,
          .area_ratio = 0.669,
          .hub_ratio = 0.301,
          .hub_length = 1.236,
          .axis = Axis::z,
          .edge_length = panel,
          .blade_edge_length = blade_edge_length};
}

PropellerShape any_propeller(std::mt19937_64& random) {
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  PropellerShape shape{.blades = 4 + static_cast<int>(random() % 4), .diameter = between(0.1, 8)};
  shape.pitch_ratio = between(0.5, 1.5);
  shape.area_ratio = between(0.35, 1.0);
  shape.hub_ratio = between(0.18, 0.4);
  shape.hub_length = shape.diameter * between(0.35, 0.6);
  shape.rake = between(-5, 15) * degree;
  shape.skew = between(0, 40) * degree;
  shape.thickness_factor = between(1, 2);
  shape.edge_thickness = between(0.05, 0.3);
  shape.hand = random() % 2 ? Hand::left : Hand::right;
  shape.axis = static_cast<Axis>(random() % 3);
  shape.edge_length = shape.diameter * between(0.02, 0.05);
  shape.blade_edge_length = random() % 2 ? shape.edge_length * between(0.3, 1) : 0;
  if (random() % 3 == 0) {
    const double chord = between(0.2, 0.4), tip = random() % 2 ? 0 : 0.5 * chord;
    shape.sections = PropellerSections{.radius = {0.15, 0.5, 0.8, 1},
                                       .chord = {0.8 * chord, chord, chord, tip},
                                       .thickness = {0.04, 0.025, 0.012, 0.004},
                                       .pitch = {0.9, 1.0, 1.0, between(0.7, 1)},
                                       .rake = {},
                                       .skew = {},
                                       .camber = {}};
    if (random() % 2) shape.sections->camber = {0.01, 0.02, 0.02, 0};
    if (random() % 2) shape.sections->skew = {0, 0.05, 0.2, 0.4};
    if (random() % 2) shape.sections->rake = {0, 0.01, 0.03, 0.05};
  }
  return shape;
}

/// A random one that is not rejected.
PropellerShape some_propeller(std::mt19937_64& random) {
  for (;;) {
    const PropellerShape shape = any_propeller(random);
    try {
      make_propeller(shape);
      return shape;
    } catch (const InputError&) {  // the hub is too short for the root
    }
  }
}

/// One part, with unchanged vertices.
Panels part(const Panels& all, const std::string& name) {
  Panels one;
  one.vertices = all.vertices;
  for (std::size_t p = 0; p < all.panels.size(); ++p)
    if (all.part_names[static_cast<std::size_t>(all.part[p])] == name) one.panels.push_back(all.panels[p]);
  return one;
}

double volume(const Panels& panels) {
  double sum = 0;
  fixtures::for_each_triangle(panels, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) { sum += dot(a, cross(b, c)) / 6; });
  return sum;
}

/// A section's area by the trapezoidal rule through thickness, times the step along the radius: volumes of thin slices between cylinders.
double blade_volume(const BladeForm& form) {
  constexpr int slices = 400, strips = 800;
  double sum = 0;
  const double step = (form.tip_radius() - form.root_radius()) / slices;
  for (int i = 0; i < slices; ++i) {
    const double r = form.root_radius() + (i + 0.5) * step;
    const BladeForm::Section section = form.section(r);
    // on the unrolled cylinder: area of the polygon (arc, axial)
    const auto unrolled = [&](double along, double through) {
      const Vec3d p = form.place(section, along, through);
      return std::pair{r * std::atan2(p.y, p.x), p.z};
    };
    double area = 0;
    auto from = unrolled(-1, 0);
    const auto go_to = [&](double along, double through) {
      const auto to = unrolled(along, through);
      area += 0.5 * (from.first * to.second - to.first * from.second);
      from = to;
    };
    for (int k = 1; k <= strips; ++k) go_to(-1 + 2.0 * k / strips, 0);
    for (int k = strips; k >= 0; --k) go_to(-1 + 2.0 * k / strips, 1);
    go_to(-1, 0);
    sum += std::fabs(area) * step;
  }
  return sum;
}

}  // namespace

TEST_CASE("wageningen: chord, thickness and pitch angle of a B4-66.9 of 4.12 m are those of the series' tables") {
  const BladeForm form(b4(0.2, 0.2));
  struct Row {
    double r, chord, thickness, angle;  // [m] [mm] [deg], calculated by hand from the tables, to the digits shown
  };
  for (const Row& row : {Row{0.2, 1.145, 151, 44.8}, Row{0.3, 1.297, 133, 35.6}, Row{0.4, 1.413, 116, 29.9}, Row{0.5, 1.483, 99, 25.6},
                         Row{0.6, 1.507, 82, 22.0}, Row{0.7, 1.477, 64, 19.1}, Row{0.8, 1.358, 47, 16.8}, Row{0.9, 1.090, 30, 15.1}, Row{1.0, 0, 12, 13.6}}) {
    const BladeForm::Section section = form.section(row.r * 2.06);
    CHECK(std::fabs(section.chord - row.chord) < 0.0006);
    CHECK(std::fabs(1000 * section.thickness - row.thickness) < 0.6);
    CHECK(std::fabs(section.pitch_angle / degree - row.angle) < 0.06);
  }
}

TEST_CASE("wageningen: integrated from the hub of the series the expanded area ratio is 0.6699 for 0.669") {
  CHECK(BladeForm(b4(0.2, 0.2)).expanded_area_ratio(wageningen::hub) == fixtures::relative(0.669907, 1e-6));  // another program's integral of the same curve
  double sum = 0;                                                                                             // the area of the chords, strip by strip
  const BladeForm form(b4(0.2, 0.2));
  constexpr int strips = 200000;
  for (int k = 0; k < strips; ++k) sum += form.section(2.06 * (0.167 + 0.833 * (k + 0.5) / strips)).chord * 2.06 * 0.833 / strips;
  CHECK(4 * sum / (pi * 2.06 * 2.06) == fixtures::relative(form.expanded_area_ratio(0.167), 1e-6));  // midpoints at the root-like end of the chord
}

TEST_CASE("wageningen: at every radius the face falls from the edges to the crest and the bulge rises to it, and neither changes abruptly with the radius") {
  for (double r = 0.15; r <= 1; r += 0.01) {
    for (int k = 0; k < 200; ++k) {
      const double p = -1 + 0.01 * k, q = p + 0.01;
      const bool is_behind = q <= 1e-9;  // of the crest, towards the trailing edge
      CHECK((wageningen::rise(r, q) - wageningen::rise(r, p)) * (is_behind ? 1 : -1) >= -1e-12);
      CHECK((wageningen::face(r, q) - wageningen::face(r, p)) * (is_behind ? -1 : 1) >= -1e-12);
      // with the radius the tables change by less than 0.12 per tenth of it, at the leading edge of the face between 0.2 and 0.5
      CHECK(std::fabs(wageningen::rise(r + 0.01, p) - wageningen::rise(r, p)) < 0.018);
      CHECK(std::fabs(wageningen::face(r + 0.01, p) - wageningen::face(r, p)) < 0.018);
    }
  }
}

TEST_CASE("propeller: the panels have the chord and thickness of the table at 0.7 R") {
  const BladeForm form(b4(0.2, 0.2));
  const BladeForm::Section section = form.section(0.7 * 2.06);
  // along the helix of the pitch angle; face and back of the series at 0.7 R: a flat face, so thickness is measured across it
  const Vec3d impose_displacements = form.place(section, 1, 0), trail = form.place(section, -1, 0);
  const double arc = 1.442 * (std::atan2(impose_displacements.y, impose_displacements.x) - std::atan2(trail.y, trail.x));
  CHECK(std::hypot(arc, impose_displacements.z - trail.z) == fixtures::relative(4.12 * 2.144 * 0.669 / 4, 1e-12));
  CHECK(std::atan2(impose_displacements.z - trail.z, arc) == fixtures::relative(std::atan(0.76 / (0.7 * pi)), 1e-12));
  double thickest = 0;
  for (int k = 0; k <= 1000; ++k) {
    const Vec3d face = form.place(section, -1 + 0.002 * k, 0), back = form.place(section, -1 + 0.002 * k, 1);
    const double turn = 1.442 * (std::atan2(back.y, back.x) - std::atan2(face.y, face.x));
    thickest = fixtures::larger(thickest, std::hypot(turn, back.z - face.z));
  }
  CHECK(thickest == fixtures::relative(4.12 * (0.0216 - 4 * 0.0015), 1e-5));  // a thousand samples miss the greatest by 1e-6 of the bulge
}

TEST_CASE("propeller: a blade of the B4-66.9 has a volume of 0.118 m³ by the integral over its sections, and panels converge to it") {
  const double exact = blade_volume(BladeForm(b4(0.2, 0.2)));
  CHECK(exact == fixtures::absolute(0.117, 0.0015, "m3"));  // of panels made by another program: its three digits, and a per cent that chords lose
  const double coarse = volume(part(make_propeller(b4(0.2, 0.05)), "blade_1")), fine = volume(part(make_propeller(b4(0.1, 0.025)), "blade_1"));
  CHECK(std::fabs(fine - exact) < 0.5 * std::fabs(coarse - exact));  // chords are off by the square of their length: a quarter, or somewhat more
  CHECK(fine == fixtures::relative(exact, 0.01));
}

TEST_CASE("propeller: hub and blades of random propellers are closed, oriented outward, embedded in the hub, and without self-intersection") {
  std::mt19937_64 random(1);
  for (int made = 0; made < 25; ++made) {
    const PropellerShape shape = some_propeller(random);
    const Panels all = make_propeller(shape);
    CAPTURE(made);
    const Surface surface(all);
    CHECK(surface.is_closed());
    CHECK_FALSE(surface.report().flipped);
    CHECK(surface.report().welded + surface.report().degenerate + surface.report().rewound == 0);
    CHECK(surface.solids() == static_cast<std::size_t>(shape.blades) + 1);
    CHECK(self_intersections(surface, Bvh(surface)).crossings == 0);
    for (const std::string& name : all.part_names) {
      const Panels one = part(all, name);
      CHECK(fixtures::is_watertight(one));
      CHECK(fixtures::euler_characteristic(one) == 2);
      CHECK(volume(one) > 0);
    }
    // the root of each blade is within the hub: the innermost vertices wind about nothing else
    const Panels hub = part(all, "hub"), blade = part(all, "blade_1");
    const auto axis = static_cast<std::size_t>(shape.axis);
    const double root = BladeForm(shape).root_radius();
    int inside = 0;
    for (const auto& p : blade.panels) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec3d& v = all.vertices[static_cast<std::size_t>(p[c])];
        if (std::hypot(v[(axis + 1) % 3], v[(axis + 2) % 3]) > root * (1 + 1e-9)) continue;
        CHECK(fixtures::winding_number(hub, v) == fixtures::relative(1, 1e-9));
        ++inside;
      }
    }
    CHECK(inside >= 4);
  }
}

TEST_CASE("propeller: no edge is longer than requested at its middle, and edges at outline and tip have the requested size") {
  std::mt19937_64 random(2);
  for (int made = 0; made < 15; ++made) {
    PropellerShape shape = some_propeller(random);
    shape.axis = Axis::z, shape.hand = Hand::right, shape.blade_edge_length = 0.25 * shape.edge_length;
    const Panels all = make_propeller(shape);
    const BladeForm form(shape);
    double longest = 0, longest_at_tip = 0;
    const double thick = form.section(form.root_radius()).edge_thickness;
    fixtures::for_each_triangle(part(all, "blade_1"), [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
      for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
        const double rp = std::hypot(p.x, p.y), rq = std::hypot(q.x, q.y), length = norm(p - q);
        if (std::fmax(rp, rq) < form.root_radius() * (1 + 1e-9)) continue;  // of the root, inside the hub
        longest = fixtures::larger(longest, length);
        if (std::fmin(rp, rq) > form.tip_radius() - 0.5 * shape.blade_edge_length) longest_at_tip = fixtures::larger(longest_at_tip, length);
      }
    });
    CAPTURE(made);
    CHECK(longest <= std::hypot(shape.edge_length, thick) * (1 + 1e-12));                                 // diagonals of the band along the outline
    CHECK(longest > 0.5 * shape.edge_length);                                                             // not needlessly fine: bisection stops in time
    CHECK(longest_at_tip <= std::hypot(shape.blade_edge_length * (1 + 0.3 * 0.5), thick) * (1 + 1e-12));  // size grows by 0.3 of the distance
  }
}

TEST_CASE("propeller: left is the mirror image of right, and the right one advances while it rotates from x towards y about z") {
  const PropellerShape right = b4(0.3, 0.3);
  PropellerShape left = right;
  left.hand = Hand::left;
  const Panels a = make_propeller(right), b = make_propeller(left);
  REQUIRE(a.vertices.size() == b.vertices.size());
  for (std::size_t v = 0; v < a.vertices.size(); ++v) CHECK(b.vertices[v] == Vec3d{a.vertices[v].x, -a.vertices[v].y, a.vertices[v].z});
  CHECK(volume(a) == fixtures::relative(volume(b), 1e-12));
  // the leading edge is ahead in the sense of rotation, and forward
  const BladeForm form(right);
  const BladeForm::Section section = form.section(0.7 * 2.06);
  const Vec3d impose_displacements = form.place(section, 1, 0.5), trail = form.place(section, -1, 0.5);
  CHECK(std::atan2(impose_displacements.y, impose_displacements.x) > std::atan2(trail.y, trail.x));
  CHECK(impose_displacements.z > trail.z);
  CHECK(form.place(section, 0, 1).z > form.place(section, 0, 0).z);  // the back faces forward
}

TEST_CASE("propeller: another axis exchanges the coordinates cyclically") {
  PropellerShape shape = b4(0.4, 0.4);
  const Panels about_z = make_propeller(shape);
  shape.axis = Axis::x;
  const Panels about_x = make_propeller(shape);
  shape.axis = Axis::y;
  const Panels about_y = make_propeller(shape);
  for (std::size_t v = 0; v < about_z.vertices.size(); ++v) {
    const Vec3d& p = about_z.vertices[v];
    CHECK(about_x.vertices[v] == Vec3d{p.z, p.x, p.y});
    CHECK(about_y.vertices[v] == Vec3d{p.y, p.z, p.x});
  }
}

TEST_CASE("propeller: rake moves the tip aft, skew along the helix, thickness_factor thickens") {
  const auto tip = [](auto change) {
    PropellerShape shape = b4(0.2, 0.2);
    change(shape);
    const BladeForm form(shape);
    return form.place(form.section(2.06), 0, 0);
  };
  const Vec3d plain = tip([](PropellerShape&) {}), raked = tip([](PropellerShape&s) { s.rake = 15 * degree; }),
              skewed = tip([](PropellerShape&s) { s.skew = 30 * degree; });
  CHECK(raked.z - plain.z == fixtures::relative(-2.06 * std::tan(15 * degree), 1e-12));
  CHECK(std::atan2(skewed.y, skewed.x) - std::atan2(plain.y, plain.x) == fixtures::relative(-30 * degree, 1e-12));
  CHECK(skewed.z - plain.z == fixtures::relative(-0.76 * 4.12 * 30 / 360, 1e-12));  // a twelfth of the pitch
  PropellerShape thick = b4(0.2, 0.2);
  thick.thickness_factor = 1.8;
  CHECK(BladeForm(thick).section(1.5).thickness == fixtures::relative(1.8 * BladeForm(b4(0.2, 0.2)).section(1.5).thickness, 1e-14));
}

TEST_CASE("propeller: specified sections are reproduced at their radii") {
  PropellerShape shape = b4(0.2, 0.2);
  shape.blades = 3;
  shape.sections = PropellerSections{.radius = {0.3, 0.6, 1},
                                     .chord = {0.2, 0.35, 0.1},
                                     .thickness = {0.04, 0.02, 0.01},
                                     .pitch = {0.8, 1.0, 0.9},
                                     .rake = {0, 0.02, 0.05},
                                     .skew = {0, 0.1, 0.5},
                                     .camber = {0.01, 0.03, 0.0}};
  const BladeForm form(shape);
  const double r = 0.6 * 2.06;
  const BladeForm::Section section = form.section(r);
  CHECK(section.chord == fixtures::relative(0.35 * 4.12, 1e-14));
  CHECK(section.thickness == fixtures::relative(0.02 * 4.12, 1e-14));
  CHECK(section.pitch_angle == fixtures::relative(std::atan(1.0 / (0.6 * pi)), 1e-14));
  const Vec3d middle = 0.5 * (form.place(section, 0, 0) + form.place(section, 0, 1));
  // the middle of the chord lags by the skew, apart from the mean line's height above the chord, 3 % of it, across the pitch angle
  const double height = 0.03 * 0.35 * 4.12;
  CHECK(std::atan2(middle.y, middle.x) == fixtures::relative(-0.1 - height * std::sin(section.pitch_angle) / r, 1e-3));  // the mean of two points of a circle
  CHECK(middle.z == fixtures::relative(-0.02 * 4.12 - 0.1 * 1.0 * 4.12 / (2 * pi) + height * std::cos(section.pitch_angle), 1e-12));
}

TEST_CASE("propeller: inconsistent dimensions are rejected with a message") {
  const auto complaint = [](void (*change)(PropellerShape&)) {
    PropellerShape shape = b4(0.3, 0.1);
    change(shape);
    try {
      make_propeller(shape);
      return std::string();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  const auto sections = [](PropellerShape& s) -> PropellerSections& {
    s.hub_length = 2;
    return s.sections.emplace(PropellerSections{
        .radius = {0.3, 0.7, 1}, .chord = {0.3, 0.3, 0}, .thickness = {0.04, 0.02, 0.01}, .pitch = {1, 1, 1}, .rake = {}, .skew = {}, .camber = {}});
  };
  static const auto own = sections;
  CHECK(complaint([](PropellerShape&) {}).empty());
  CHECK(complaint([](PropellerShape& s) { own(s); }).empty());
  CHECK(complaint([](PropellerShape& s) { s.blades = 3; }) ==
        "propeller: the tables of the Wageningen B-series are for 4 to 7 blades, not 3; specify `sections` for others.");
  CHECK(complaint([](PropellerShape& s) { s.blade_edge_length = 0.4; }) ==
        "propeller: blade_edge_length is 0.4 m, but edges are made finer, not coarser, than edge_length, 0.3 m.");
  CHECK(complaint([](PropellerShape& s) { s.hub_length = 0.5; }).starts_with("propeller: the roots of the blades reach 0."));
  CHECK(complaint([](PropellerShape& s) {
          own(s).radius = {0.4, 0.7, 1};
        }) == "propeller: sections.radius begins at 0.4, outside the hub of hub_ratio 0.301; give a section at the hub's radius or within.");
  CHECK(complaint([](PropellerShape& s) {
          own(s).radius = {0.3, 0.7, 0.6};
        }) == "propeller: sections.radius goes from 0.7 to 0.6, but each radius must be greater than the one before.");
  CHECK(complaint([](PropellerShape& s) { own(s).radius = {0.3, 0.7, 0.9}; }) == "propeller: sections.radius ends at 0.9, but the tip is at 1; radii are r/R.");
  CHECK(complaint([](PropellerShape& s) { own(s).chord.pop_back(); }) ==
        "propeller: sections.chord has 2 numbers, but sections.radius has 3; give one for each radius.");
  CHECK(complaint([](PropellerShape& s) { own(s).skew = {0.1}; }) ==
        "propeller: sections.skew has 1 numbers, but sections.radius has 3; give one for each radius.");
  CHECK(complaint([](PropellerShape& s) { own(s).chord[1] = 0; }) == "propeller: sections.chord is 0 at r/R 0.7, but only the tip may have none.");
  CHECK(complaint([](PropellerShape& s) { own(s).thickness[2] = 0; }) == "propeller: sections.thickness is 0 at r/R 1, but it must be above 0.");
  CHECK(complaint([](PropellerShape& s) { s.blade_edge_length = 1e-6; }).find("more than the limit of 1e+08") != std::string::npos);
}
