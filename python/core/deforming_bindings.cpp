#include "deforming_bindings.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "contact_rows.hpp"
#include "fccda/api/deforming_contact_detector.hpp"
#include "fccda/deforming/step_warnings.hpp"
#include "given_surface.hpp"
#include "threads.hpp"

namespace perimpact::python {

/// fccda::DeformingContact as a NumPy record.
struct DeformingContactRow {
  ContactRow contact;
  std::int32_t vertices[3];
  double weights[3], corners[3][3], displacement[3];
};

namespace {

using namespace py::literals;
using fccda::DeformingContact;
using fccda::DeformingContactDetector;
using fccda::DeformingSurface;
using fccda::InputError;
using DeformingContactRows = py::array_t<DeformingContactRow, py::array::c_style>;

std::shared_ptr<DeformingSurface> deforming_surface_of(const GivenSurface& surface) { return std::make_shared<DeformingSurface>(surface.surface()); }

std::size_t vertices_of(const DeformingSurface& surface) { return surface.at_t1().panels().vertices.size(); }

void move_surface(DeformingSurface& surface, const py::object& vertices) {
  py::array keep;
  const fccda::ConstVectors from = vectors_in(vertices, "vertices", keep, each_vertex);
  std::vector<Vec3d> to(from.size());
  for (std::size_t v = 0; v < to.size(); ++v) to[v] = from[v];
  surface.move(to);
}

DeformingContactRow deforming_row_of(const DeformingContact& contact) {
  const fccda::PanelPlace& place = contact.place;
  DeformingContactRow row{.contact = row_of(contact.contact), .vertices = {}, .weights = {}, .corners = {}, .displacement = {}};
  std::copy(place.vertices.begin(), place.vertices.end(), row.vertices);
  std::copy(place.weights.begin(), place.weights.end(), row.weights);
  put(row.corners[0], place.corners.a), put(row.corners[1], place.corners.b), put(row.corners[2], place.corners.c);
  put(row.displacement, place.displacement);
  return row;
}

DeformingContact deforming_contact_of(const DeformingContactRow& row, std::size_t points, std::size_t vertices, const DeformingContactDetector* detector) {
  DeformingContact contact{.contact = contact_of(row.contact, points, detector ? &detector->detector() : nullptr), .place = {}};
  fccda::PanelPlace& place = contact.place;
  for (const std::int32_t vertex : row.vertices)
    if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertices)
      throw InputError(fmt::format("contacts refers to vertex {}, but vertex_impulses has {} rows; give one for each vertex of the mesh.", vertex, vertices));
  std::copy(row.vertices, row.vertices + 3, place.vertices.begin());
  std::copy(row.weights, row.weights + 3, place.weights.begin());
  place.corners = {vector_in(row.corners[0]), vector_in(row.corners[1]), vector_in(row.corners[2])};
  place.displacement = vector_in(row.displacement);
  return contact;
}

DeformingContactRows detect_deforming(DeformingContactDetector& detector, const py::object& x_t0, const py::object& x_t1,
                                      const std::optional<py::object>& radius) {
  py::array at_t0, at_t1, radii;
  const fccda::ConstVectors from = vectors_in(x_t0, "x_t0", at_t0), to = vectors_in(x_t1, "x_t1", at_t1);
  std::optional<fccda::Numbers> of_each;
  if (radius) of_each = each_in(*radius, "radius", radii);
  use_chosen_threads();
  std::vector<DeformingContact> contacts;
  {
    const py::gil_scoped_release release;
    contacts = of_each ? detector.detect(from, to, *of_each) : detector.detect(from, to);
  }
  DeformingContactRows rows(static_cast<py::ssize_t>(contacts.size()));
  std::transform(contacts.begin(), contacts.end(), rows.mutable_data(), [](const DeformingContact& contact) { return deforming_row_of(contact); });
  return rows;
}

py::array_t<std::int64_t> inside_deforming(const DeformingContactDetector& detector, const py::object& x, const std::optional<py::object>& radius) {
  py::array places, radii;
  const fccda::ConstVectors at = vectors_in(x, "x", places);
  return array_of(radius ? detector.points_inside(at, each_in(*radius, "radius", radii)) : detector.points_inside(at));
}

fccda::ContactSum respond_deforming(const DeformingContactRows& rows, double dt, const py::object& x_t0, const py::array& x_t1, const py::array& velocity,
                                    const py::object& mass, const py::array& vertex_impulses, const std::optional<py::object>& vertex_mass, double friction,
                                    const DeformingContactDetector* detector) {
  if (friction != 0 && !detector)
    throw InputError("friction requires the detector of the contacts, which limits sliding at obstructing panels; pass detector=… to respond_deforming.");
  expect_one_dimension(rows);
  py::array at_t0, masses, of_vertices;
  const fccda::ConstVectors from = vectors_in(x_t0, "x_t0", at_t0);
  const fccda::PointArrays points{
      .x_t0 = from, .x_t1 = writable_vectors_in(x_t1, "x_t1"), .velocity = writable_vectors_in(velocity, "velocity"), .mass = each_in(mass, "mass", masses)};
  const fccda::Vectors impulses = writable_vectors_in(vertex_impulses, "vertex_impulses", each_vertex);
  const fccda::Numbers mass_of_each = vertex_mass ? each_in(*vertex_mass, "vertex_mass", of_vertices, each_vertex) : fccda::Numbers(fccda::prescribed_motion);
  std::vector<DeformingContact> contacts;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) contacts.push_back(deforming_contact_of(*rows.data(i), from.size(), impulses.size(), detector));
  return fccda::respond(contacts, dt, points, friction, mass_of_each, impulses);
}

void bind_deforming_surface(py::module_& module) {
  py::class_<DeformingSurface, std::shared_ptr<DeformingSurface>>(
      module, "DeformingSurface",
      R"(A surface whose vertices move, with the connectivity of construction: a hull that bends, a net, the boundary of a finite-element mesh.

In each step every vertex moves straight and uniformly. Any number of detectors may share one surface; it is moved once in each step, also where it is at rest.)")
      .def(py::init(&deforming_surface_of), "surface"_a,
           R"(surface: where the vertices are at the start; it is copied.

Raises InputError where closed parts of the surface may overlap: their union is evaluated for rigid surfaces only.)")
      .def("move", &move_surface, "vertices"_a,
           R"(Begins a step, which starts where the last one ended. vertices: (n, 3) positions at the end of the step [m], numbered as the vertices of the Mesh
that the surface was made of; not modified.

Raises RunError if one is not finite or moves farther than 1e6 sizes of the surface, and InputError if their number differs, welded vertices part, a
panel loses its area, or a closed surface is turned inside out. Nothing changes then.)")
      .def("step_warnings", &fccda::step_warnings,
           R"(Sentences about the step that the surface has begun: panels that move farther than their longest edge, turn by more than 90°, or pass through
others at its end. Empty if there is nothing to report. Takes longer than move: for a check now and then.)")
      .def_property_readonly("vertex_count", &vertices_of, "Number of vertices of the Mesh that the surface was made of: the rows that move takes.");
}

void bind_deforming_detector(py::module_& module) {
  py::class_<DeformingContactDetector>(
      module, "DeformingContactDetector",
      R"(Continuous collision detection between points and a surface whose vertices move. One detector serves one set of points and caches their distances.

x_t0 of a step must be x_t1 of the previous step, as relocated; report points for which it is not with `moved`. Points may be appended or removed at the end.)")
      .def(py::init([](const std::shared_ptr<DeformingSurface>& surface, double radius) { return DeformingContactDetector(surface, radius); }), "surface"_a,
           "radius"_a = 0.0,
           R"(surface: followed by the detector, not copied.
radius: contact radius of the points [m]; 0 for points without extent.)")
      .def(
          "detect", &detect_deforming, "x_t0"_a, "x_t1"_a, "radius"_a = py::none(),
          R"(Detects the contacts of the step that the surface has begun with `move`, in point order. x_t0, x_t1: (points, 3) world positions at the start and the
end of the step [m]; not modified. radius: contact radius of each point [m], for different radii; it may change from step to step.

Returns a structured array with the fields of ContactDetector.detect, and those of the place of the surface that is closest to the relocation: vertices (3
vertex numbers of its triangle, as in the mesh), weights (3 barycentric coordinates), corners (3, 3) at the end of the step [m], and displacement of this place
in the step [m].

Raises InputError if the surface was not moved since the last detection or the numbers of positions differ, and RunError if a position is not finite or a
point moves farther than 1e6 sizes of the surface.)")
      .def("points_inside", &inside_deforming, "x"_a, "radius"_a = py::none(),
           "Indices of the points x (points, 3) [m] that are inside the surface where it is now, or closer than the contact radius (`radius` per point [m] if "
           "given); for use before the first step.")
      .def(
          "moved", [](DeformingContactDetector& detector, std::size_t point) { detector.moved(point); }, "point"_a,
          "Declares that the point has been displaced since the last step.")
      .def("points_changed", &DeformingContactDetector::points_changed,
           "Declares that points were renumbered, or many displaced: discards the cached distances.");
}

void bind_deforming_response(py::module_& module) {
  module.def(
      "respond_deforming", &respond_deforming, "contacts"_a, "dt"_a, py::kw_only(), "x_t0"_a, "x_t1"_a.noconvert(), "velocity"_a.noconvert(), "mass"_a,
      "vertex_impulses"_a.noconvert(), "vertex_mass"_a = py::none(), "friction"_a = 0.0, "detector"_a = py::none(),
      R"(Contact response at a deforming surface: relocates the points in contact, updates their velocities, and adds the impulses on the surface to its vertices.

dt: duration of the step [s]. x_t1 [m] and velocity [m/s], with which the points moved from x_t0 to x_t1, are (points, 3) arrays of float64 or float32, modified
in place. mass [kg]: one number, or one per point. vertex_impulses [N s]: (n, 3) array of float64 or float32, one row per vertex of the mesh, to which the
impulses are added; apply them to the vertices in your solver. vertex_mass [kg]: one number, or one per vertex; infinite, or None for all, where the motion is
prescribed. friction: Coulomb friction coefficient. detector: the detector of these contacts, in this step; required with friction, and
advisable without, as for respond.

Returns the ContactSum, its angular impulse about the origin. Points and vertices together conserve linear momentum, and angular momentum with positions at
t1. Raises InputError if arrays differ in length, dt or a mass of a vertex is not positive, or a mass, velocity or the friction is negative or not finite.)");
}

}  // namespace

void bind_deforming(py::module_& module) {
  PYBIND11_NUMPY_DTYPE_EX(DeformingContactRow, contact.point, "point", contact.panel, "panel", contact.time_fraction, "time_fraction", contact.depth, "depth",
                          contact.radius, "radius", contact.offset, "offset", contact.hit, "hit", contact.normal, "normal", contact.relocation, "relocation",
                          contact.normal_t0, "normal_t0", vertices, "vertices", weights, "weights", corners, "corners", displacement, "displacement");
  bind_deforming_surface(module);
  bind_deforming_detector(module);
  bind_deforming_response(module);
}

}  // namespace perimpact::python
