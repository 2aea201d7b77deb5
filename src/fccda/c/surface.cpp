#include <sstream>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "fccda/c/convert.hpp"
#include "fccda/c/guarded.hpp"
#include "fccda/c/handles.hpp"
#include "marine/hull.hpp"
#include "marine/propeller.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"
#include "mesh/shapes/sphere.hpp"
#include "mesh_io/read_panels.hpp"

using namespace fccda;
using namespace fccda::c_interface;

namespace {

Surface::Options options_of(const fccda_surface_options* given) {
  Surface::Options options;
  if (given == nullptr) return options;
  expect_reserved(given->reserved, "options");
  if (given->orientation < FCCDA_UNDECLARED || given->orientation > FCCDA_REVERSED)
    throw InputError("surface: the orientation is " + std::to_string(given->orientation) +
                     ", but it must be FCCDA_UNDECLARED, FCCDA_NORMALS or FCCDA_REVERSED.");
  options.orientation = static_cast<Orientation>(given->orientation);
  options.weld_distance = given->weld_distance;
  if (given->name != nullptr) options.name = given->name;
  return options;
}
static_assert(static_cast<int>(Orientation::normals) == FCCDA_NORMALS && static_cast<int>(Orientation::reversed) == FCCDA_REVERSED);

std::size_t dropped(const SurfaceReport& report) { return report.degenerate + report.duplicate + report.back_to_back; }

std::string text_of(const SurfaceReport& report) {
  std::ostringstream text;
  text << report.panels << " panels, " << report.triangles << " triangles, " << report.vertices << " vertices, " << report.components << " components, "
       << (report.closure == Closure::closed ? "closed" : "open") << '\n';
  const auto line = [&](std::size_t count, const char* what) {
    if (count > 0) text << "repaired: " << count << ' ' << what << '\n';
  };
  line(report.welded, "coincident vertices merged");
  line(report.degenerate, "triangles of zero area removed");
  line(report.duplicate, "duplicate panels removed");
  line(report.back_to_back, "pairwise back-to-back triangles removed");
  line(report.non_manifold_edge_count - report.cut_edges, "non-manifold edges, where parts touch, paired");
  line(report.cut_edges, "non-manifold edges cut");
  line(report.rewound, "triangles reoriented to match their neighbours");
  line(report.flipped, "closed components with inward normals reversed");
  return text.str();
}

/// Writes the handle of a surface to `surface`.
void create(const Panels& panels, const Surface::Options& options, fccda_surface*& surface) {
  Surface made(panels, options);
  std::string report = text_of(made.report());
  surface = new fccda_surface{share(std::move(made)), std::move(report)};
}

/// The same of panels that `panels()` makes, within a function of C.
template <class MakePanels>
fccda_status create_from(const MakePanels& panels, const fccda_surface_options* options, fccda_surface** surface) {
  return guarded([&] {
    fccda_surface*& out = given(surface, "surface");
    out = nullptr;
    create(panels(), options_of(options), out);
  });
}

Panels panels_of(const fccda_vectors& vertices, const int32_t* panels, std::size_t count, int32_t corners) {
  if (corners != 3 && corners != 4)
    throw InputError("surface: the panels have " + std::to_string(corners) + " corners, but they must have 3, or 4 of which the last is -1 in a triangle.");
  if (count > 0) given(panels, "panels");
  Panels out;
  const ConstVectors view = const_vectors_of(vertices, "vertices");
  out.vertices.reserve(view.size());
  for (std::size_t v = 0; v < view.size(); ++v) out.vertices.push_back(view[v]);
  out.panels.reserve(count);
  for (const int32_t* p = panels; p != panels + count * static_cast<std::size_t>(corners); p += corners)
    out.panels.push_back({p[0], p[1], p[2], corners == 4 ? p[3] : -1});
  return out;
}

Axis axis_of(int32_t axis, const char* shape) {
  if (axis < 0 || axis > 2) throw InputError(std::string(shape) + ": the axis is " + std::to_string(axis) + ", but it must be 0, 1 or 2 for x, y or z.");
  return static_cast<Axis>(axis);
}

double or_default(double given, double otherwise) { return given == 0 ? otherwise : given; }

HullShape shape_of(const fccda_hull& hull) {
  const HullShape defaults;
  return {.length = hull.length,
          .breadth = hull.breadth,
          .draft = hull.draft,
          .freeboard = hull.freeboard,
          .stem_angle = hull.stem_angle,
          .waterline_angle = hull.waterline_angle,
          .fullness = or_default(hull.fullness, defaults.fullness),
          .stern_angle = or_default(hull.stern_angle, defaults.stern_angle),
          .stern_waterline_angle = or_default(hull.stern_waterline_angle, defaults.stern_waterline_angle),
          .bilge_radius = hull.bilge_radius,
          .stem_radius = hull.stem_radius,
          .flare = hull.flare,
          .edge_length = hull.edge_length,
          .bow_edge_length = hull.bow_edge_length};
}

PropellerShape shape_of(const fccda_propeller& propeller) {
  expect_reserved(propeller.reserved, "propeller");
  const PropellerShape defaults;
  return {.blades = propeller.blades,
          .diameter = propeller.diameter,
          .pitch_ratio = propeller.pitch_ratio,
          .area_ratio = propeller.area_ratio,
          .hub_ratio = propeller.hub_ratio,
          .hub_length = propeller.hub_length,
          .rake = propeller.rake,
          .skew = propeller.skew,
          .thickness_factor = or_default(propeller.thickness_factor, defaults.thickness_factor),
          .edge_thickness = or_default(propeller.edge_thickness, defaults.edge_thickness),
          .hand = propeller.is_left_handed ? Hand::left : Hand::right,
          .axis = axis_of(propeller.axis, "propeller"),
          .sections = std::nullopt,
          .edge_length = propeller.edge_length,
          .blade_edge_length = propeller.blade_edge_length};
}

fccda_surface_info info_of(const Surface& surface) {
  const SurfaceReport& report = surface.report();
  fccda_surface_info info{};
  info.panels = static_cast<int64_t>(report.panels);
  info.panel_vertices = static_cast<int64_t>(surface.panels().vertices.size());
  info.triangles = static_cast<int64_t>(report.triangles);
  info.vertices = static_cast<int64_t>(report.vertices);
  info.repairs = static_cast<int64_t>(report.welded + dropped(report) + report.rewound + report.flipped + report.non_manifold_edge_count);
  info.is_closed = surface.is_closed() ? 1 : 0;
  info.area = report.area;
  info.volume = report.volume;
  write(report.centroid, info.centroid);
  write(report.bounds.low, info.low);
  write(report.bounds.high, info.high);
  return info;
}

void expect_count(std::size_t given, std::size_t present, const char* of) {
  if (given != present)
    throw InputError("surface: the array has space for " + std::to_string(given) + ' ' + of + ", but the surface has " + std::to_string(present) +
                     "; ask fccda_surface_measure() for their number.");
}

}  // namespace

fccda_status fccda_surface_read(const char* path, const fccda_surface_options* options, fccda_surface** surface) {
  return create_from([&] { return read_panels(&given(path, "path")); }, options, surface);
}

fccda_status fccda_surface_create(const fccda_vectors* vertices, const int32_t* panels, size_t panel_count, int32_t corners,
                                  const fccda_surface_options* options, fccda_surface** surface) {
  return create_from([&] { return panels_of(given(vertices, "vertices"), panels, panel_count, corners); }, options, surface);
}

fccda_status fccda_surface_box(const double size[3], double edge_length, fccda_surface** surface) {
  return create_from([&] { return make_box({.size = {given(size, "size"), size[1], size[2]}, .edge_length = edge_length}); }, nullptr, surface);
}

fccda_status fccda_surface_sphere(double diameter, double edge_length, fccda_surface** surface) {
  return create_from([&] { return make_sphere({.diameter = diameter, .edge_length = edge_length}); }, nullptr, surface);
}

fccda_status fccda_surface_cylinder(double diameter, double height, int32_t axis, double edge_length, fccda_surface** surface) {
  const auto panels = [&] { return make_cylinder({.diameter = diameter, .height = height, .axis = axis_of(axis, "cylinder"), .edge_length = edge_length}); };
  return create_from(panels, nullptr, surface);
}

fccda_status fccda_surface_hull(const fccda_hull* hull, fccda_surface** surface) {
  return create_from([&] { return make_hull(shape_of(given(hull, "hull"))); }, nullptr, surface);
}

fccda_status fccda_surface_propeller(const fccda_propeller* propeller, fccda_surface** surface) {
  return create_from([&] { return make_propeller(shape_of(given(propeller, "propeller"))); }, nullptr, surface);
}

fccda_status fccda_surface_measure(const fccda_surface* surface, fccda_surface_info* info) {
  return guarded([&] { given(info, "info") = info_of(given(surface, "surface").shared->surface()); });
}

const char* fccda_surface_report(const fccda_surface* surface) { return surface == nullptr ? nullptr : surface->report.c_str(); }

fccda_status fccda_surface_vertices(const fccda_surface* surface, const fccda_vectors* vertices) {
  return guarded([&] {
    const std::vector<Vec3d>& from = given(surface, "surface").shared->surface().panels().vertices;
    const Vectors to = vectors_of(given(vertices, "vertices"), "vertices");
    expect_count(to.size(), from.size(), "vertices");
    for (std::size_t v = 0; v < from.size(); ++v) to.set(v, from[v]);
  });
}

fccda_status fccda_surface_panels(const fccda_surface* surface, int32_t* panels, size_t panel_count) {
  return guarded([&] {
    const auto& from = given(surface, "surface").shared->surface().panels().panels;
    expect_count(panel_count, from.size(), "panels");
    int32_t* to = &given(panels, "panels");
    for (const std::array<int, 4>& panel : from) to = std::ranges::copy(panel, to).out;
  });
}

void fccda_surface_destroy(fccda_surface* surface) { delete surface; }
