#include "fccda_bindings.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "contact_rows.hpp"
#include "fccda/api/contact_detector.hpp"
#include "fccda/api/respond_arrays.hpp"
#include "fccda/contact_bounds/box_union.hpp"
#include "fccda/rigid_body/solid.hpp"
#include "given_surface.hpp"
#include "mesh.hpp"
#include "threads.hpp"

namespace perimpact::python {

namespace {

using namespace py::literals;
using fccda::InputError;
using fccda::Motion;
using fccda::Pose;
using fccda::RigidBody;
using fccda::Surface;

/// The advice in messages of the library, in Python terms.
constexpr fccda::AdviceWords python_words{.declare_orientation = "with orientation=\"normals\" (the one that the normals point to) or orientation=\"reversed\"",
                                          .cut_open = "with orientation=\"normals\" (the side that the normals point to)",
                                          .clip = "pass clip=True"};
using Boxes = std::vector<std::pair<Vec3d, Vec3d>>;

// ---- surfaces ----

GivenSurface surface_of(const Mesh& mesh, double weld, const std::string& outside, const std::string& name) {
  if (!(weld >= 0 && std::isfinite(weld))) throw InputError(fmt::format("weld is {} m, but it must be at least 0 and finite.", weld));
  fccda::Orientation side = fccda::Orientation::undeclared;
  if (outside == "normals")
    side = fccda::Orientation::normals;
  else if (outside == "reversed")
    side = fccda::Orientation::reversed;
  else if (outside != "undeclared")
    throw InputError(fmt::format("orientation is \"{}\", but it must be one of undeclared, normals, reversed.", outside));
  try {
    return GivenSurface(Surface(mesh.panels(), {.weld_distance = weld, .orientation = side, .name = name}));
  } catch (const InputError& error) {
    throw InputError(error.in_words_of(python_words));
  }
}

py::tuple bounds_of(const GivenSurface& surface) { return py::make_tuple(surface.report().bounds.low, surface.report().bounds.high); }

void bind_surface(py::module_& module) {
  py::class_<GivenSurface>(module, "Surface",
                           R"(A rigid contact surface: vertices welded, triangles oriented consistently outward. Immutable.

Detectors of one Surface share it and its search structures, so that each stores only data of its points.)")
      .def(py::init(&surface_of), "mesh"_a, "weld"_a = 0.0, "orientation"_a = "undeclared", "name"_a = "surface",
           R"(weld: vertices closer than this are merged [m]; 0: 1e-9 of the size.
orientation: of an open surface: outside is the side that the normals point to ("normals") or the opposite ("reversed"). A closed surface needs none.
name: name in messages.

Raises InputError where the surface cannot be used.)")
      .def_property_readonly(
          "is_closed", [](const GivenSurface& surface) { return surface.surface().is_closed(); }, "Whether every edge belongs to two triangles.")
      .def_property_readonly(
          "area", [](const GivenSurface& surface) { return surface.report().area; }, "Area [m2].")
      .def_property_readonly(
          "volume", [](const GivenSurface& surface) { return surface.report().volume; }, "Enclosed volume [m3]; 0 for an open surface.")
      .def_property_readonly(
          "centroid", [](const GivenSurface& surface) { return surface.report().centroid; },
          "(3,) centroid of the volume, or of the area of an open surface [m].")
      .def_property_readonly("bounds", &bounds_of, "Minimum and maximum coordinates: two arrays (3,) [m].")
      .def_property_readonly(
          "vertices", [](const GivenSurface& surface) { return array_of(surface.surface().vertices()); }, "(n, 3) vertices after welding [m], a copy.")
      .def_property_readonly(
          "triangles", [](const GivenSurface& surface) { return vertex_numbers_of(surface.surface().triangles()); },
          "(m, 3) vertex numbers of each triangle, counterclockwise seen from outside; a copy.");
}

// ---- bodies ----

fccda::Quaternion quaternion_of(const std::array<double, 4>& wxyz) {
  const fccda::Quaternion attitude{wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
  const double squared = attitude.w * attitude.w + attitude.x * attitude.x + attitude.y * attitude.y + attitude.z * attitude.z;
  constexpr double rounding = 1e-9;
  if (!(std::fabs(squared - 1) <= rounding))
    throw InputError(fmt::format("attitude has the norm {:.9g}, but must be a unit quaternion w, x, y, z.", std::sqrt(squared)));
  return attitude;
}

std::array<double, 4> numbers_in(const fccda::Quaternion& q) { return {q.w, q.x, q.y, q.z}; }

fccda::Mat3 matrix_of(const Numbers& numbers) {
  if (numbers.ndim() == 1 && numbers.shape(0) == 3) return fccda::Mat3::diagonal({numbers.at(0), numbers.at(1), numbers.at(2)});
  if (numbers.ndim() != 2 || numbers.shape(0) != 3 || numbers.shape(1) != 3)
    throw InputError(fmt::format("inertia has the shape {}, but must be (3,), about the axes of the body frame, or (3, 3).", shape_in_words(numbers)));
  fccda::Mat3 matrix{};
  for (py::ssize_t i = 0; i < 3; ++i) matrix.row[static_cast<std::size_t>(i)] = {numbers.at(i, 0), numbers.at(i, 1), numbers.at(i, 2)};
  return matrix;
}

constexpr std::array<const char*, 6> degree_names{"x", "y", "z", "rx", "ry", "rz"};

fccda::FreeDegrees degrees_of(const std::vector<std::string>& names) {
  fccda::FreeDegrees degrees;
  for (const std::string& name : names) {
    const auto known = std::find(degree_names.begin(), degree_names.end(), name);
    if (known == degree_names.end()) throw InputError(fmt::format("free_dofs has \"{}\", which is not a degree of freedom; use x, y, z, rx, ry, rz.", name));
    degrees.free[static_cast<std::size_t>(known - degree_names.begin())] = true;
  }
  return degrees;
}

void drive(RigidBody& body, const std::string& degree, double velocity) {
  const auto known = std::find(degree_names.begin(), degree_names.end(), degree);
  if (known == degree_names.end()) throw InputError(fmt::format("degree is \"{}\", but it must be one of x, y, z, rx, ry, rz.", degree));
  const auto number = static_cast<std::size_t>(known - degree_names.begin());
  if (body.degrees().free[number])
    throw InputError(fmt::format("degree {} is free, so its velocity cannot be prescribed; leave it out of free_dofs, or drive another one.", degree));
  body.drive(number, velocity);
}

struct Start {
  Vec3d position, velocity, angular_velocity;
  std::array<double, 4> attitude;
  std::vector<std::string> free;
};

RigidBody body_from(const fccda::RigidBodyProperties& properties, const Start& start) {
  return {properties, Pose(start.position, quaternion_of(start.attitude)), start.velocity, start.angular_velocity, degrees_of(start.free)};
}

py::array_t<double> moved_points(const Pose& pose, Numbers points, Vec3d (Pose::*move)(const Vec3d&) const) {
  const fccda::ConstVectors from = vectors_in(points, "points");
  std::vector<Vec3d> to;
  for (std::size_t i = 0; i < from.size(); ++i) to.push_back((pose.*move)(from[i]));
  return array_of(to);
}

void bind_bodies(py::module_& module) {
  const std::array<double, 4> unturned{1, 0, 0, 0};
  py::class_<Pose>(module, "Pose", "Pose of a body: rotation by `attitude`, then translation to `position`.")
      .def(py::init([](const Vec3d& position, const std::array<double, 4>& attitude) {
             Pose pose(position, quaternion_of(attitude));
             fccda::expect_usable(pose, "");
             return pose;
           }),
           "position"_a = Vec3d{}, "attitude"_a = unturned, "position: (3,) [m]. attitude: unit quaternion w, x, y, z.")
      .def_property_readonly("position", &Pose::position, "(3,) position of the origin of the body frame [m].")
      .def_property_readonly(
          "attitude", [](const Pose& pose) { return numbers_in(pose.attitude()); }, "Unit quaternion w, x, y, z.")
      .def_property_readonly(
          "rotation", [](const Pose& pose) { return array_of(pose.rotation()); }, "(3, 3) rotation matrix from body to world axes.")
      .def(
          "to_world", [](const Pose& pose, const Numbers& points) { return moved_points(pose, points, &Pose::to_world); }, "points"_a,
          "Transforms (n, 3) points from the body frame to world coordinates [m].")
      .def(
          "to_body", [](const Pose& pose, const Numbers& points) { return moved_points(pose, points, &Pose::to_body); }, "points"_a,
          "Transforms (n, 3) points from world coordinates to the body frame [m].")
      .def(py::pickle([](const Pose& pose) { return py::make_tuple(pose.position(), numbers_in(pose.attitude())); },
                      [](const py::tuple& state) {
                        const auto [w, x, y, z] = state[1].cast<std::array<double, 4>>();
                        return Pose(state[0].cast<Vec3d>(), {w, x, y, z});
                      }));

  py::class_<Motion>(module, "Motion", "Motion of a body over one step: rotation at constant rate about `centre`, which moves along a straight line.")
      .def(py::init([](const Pose& t0, const Pose& t1, double dt, const Vec3d& centre) {
             Motion motion{t0, t1, dt, centre};
             fccda::expect_usable(motion);
             return motion;
           }),
           "t0"_a, "t1"_a, "dt"_a, "centre"_a = Vec3d{}, "t0, t1: poses at the start and the end. dt: duration [s]. centre: (3,) in the body frame [m].")
      .def_readonly("t0", &Motion::t0, "Pose at the start.")
      .def_readonly("t1", &Motion::t1, "Pose at the end.")
      .def_readonly("dt", &Motion::dt, "Duration [s].")
      .def_readonly("centre", &Motion::centre, "(3,) centre of rotation in the body frame [m].");

  py::class_<RigidBody>(module, "RigidBody", "A rigid body with six degrees of freedom, each free or prescribed at its velocity.")
      .def(py::init([](double mass, const Vec3d& centre_of_mass, const std::optional<Numbers>& inertia, const Vec3d& position,
                       const std::array<double, 4>& attitude, const Vec3d& velocity, const Vec3d& angular_velocity, const std::vector<std::string>& free) {
             return body_from({.mass = mass, .centre_of_mass = centre_of_mass, .inertia = inertia ? matrix_of(*inertia) : fccda::Mat3{}},
                              {position, velocity, angular_velocity, attitude, free});
           }),
           "mass"_a, py::kw_only(), "centre_of_mass"_a = Vec3d{}, "inertia"_a = py::none(), "position"_a = Vec3d{}, "attitude"_a = unturned,
           "velocity"_a = Vec3d{}, "angular_velocity"_a = Vec3d{}, "free_dofs"_a = std::vector<std::string>(),
           R"(mass [kg]. centre_of_mass: (3,) in the body frame [m]. inertia: (3,) or (3, 3) about it, in the axes of the body frame [kg m2]; required where a
rotation is free. position: (3,) of the origin of the body frame [m]. attitude: unit quaternion w, x, y, z. velocity: (3,) of the centre of mass [m/s].
angular_velocity: (3,) [rad/s], world axes. free_dofs: the free degrees of freedom, of "x", "y", "z", "rx", "ry", "rz"; the velocities of the others are
prescribed.)")
      .def_static(
          "filling",
          [](const GivenSurface& surface, double density, const Vec3d& position, const std::array<double, 4>& attitude, const Vec3d& velocity,
             const Vec3d& angular_velocity, const std::vector<std::string>& free) {
            if (!surface.surface().is_closed()) throw InputError("the surface is open and encloses no volume; give mass and inertia to RigidBody.");
            if (!(density > 0)) throw InputError(fmt::format("density is {} kg/m3, but it must be above 0.", density));
            return body_from(fccda::solid_of_mass(surface.report(), density * surface.report().volume), {position, velocity, angular_velocity, attitude, free});
          },
          "surface"_a, "density"_a, py::kw_only(), "position"_a = Vec3d{}, "attitude"_a = unturned, "velocity"_a = Vec3d{}, "angular_velocity"_a = Vec3d{},
          "free_dofs"_a = std::vector<std::string>(),
          "A homogeneous solid bounded by a closed surface, which determines mass, centre of mass and inertia. density [kg/m3].")
      .def("advance", &RigidBody::advance, "dt"_a, "Advances the body by dt [s] with its velocities; returns the Motion.")
      .def("add_impulse", &RigidBody::add_impulse, "linear"_a, "angular"_a,
           "Applies an impulse to the free degrees of freedom. linear: (3,) [N s]; angular: (3,) about the centre of mass [N m s].")
      .def("drive", &drive, "degree"_a, "velocity"_a,
           "Prescribes the velocity of a degree of freedom that is not free, such as \"x\" or \"rz\" [m/s], [rad/s].")
      .def_property_readonly(
          "pose", [](const RigidBody& body) { return body.pose(); }, "Current pose, a copy.")
      .def_property_readonly("position", &RigidBody::position_of_com, "(3,) position of the centre of mass [m].")
      .def_property_readonly("velocity", &RigidBody::velocity, "(3,) velocity of the centre of mass [m/s].")
      .def_property_readonly("angular_velocity", &RigidBody::angular_velocity, "(3,) angular velocity [rad/s], world axes.")
      .def_property_readonly("mass", &RigidBody::mass, "Mass [kg].")
      .def_property_readonly(
          "inertia", [](const RigidBody& body) { return array_of(body.inertia()); }, "(3, 3) inertia about the centre of mass, world axes [kg m2].")
      .def_property_readonly("momentum", &RigidBody::momentum, "(3,) linear momentum [kg m/s].")
      .def_property_readonly("kinetic_energy", &RigidBody::kinetic_energy, "Kinetic energy of translation and rotation [J].");
}

// ---- contact ----

py::array_t<ContactRow> rows_of(const std::vector<fccda::Contact>& contacts) {
  py::array_t<ContactRow> rows(static_cast<py::ssize_t>(contacts.size()));
  ContactRow* row = rows.mutable_data();
  for (const fccda::Contact& contact : contacts) *row++ = row_of(contact);
  return rows;
}

std::vector<fccda::Contact> contacts_in(const py::array_t<ContactRow, py::array::c_style>& rows, std::size_t points, const fccda::ContactDetector* detector) {
  expect_one_dimension(rows);
  std::vector<fccda::Contact> contacts;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) contacts.push_back(contact_of(*rows.data(i), points, detector ? &detector->swept() : nullptr));
  return contacts;
}

fccda::ContactDetector detector_of(GivenSurface& surface, double radius, const std::optional<Boxes>& boxes, bool clip) {
  fccda::ContactDetector::Options options{.radius = radius};
  if (boxes) {
    std::vector<fccda::BoxUnion::Shape> shapes;
    for (const auto& [size, centre] : *boxes) shapes.push_back({size, centre});
    try {
      options.contact_bounds = fccda::BoxUnion(shapes, surface.surface(), clip ? fccda::Beyond::clip : fccda::Beyond::error);
    } catch (const InputError& error) {
      throw InputError(error.in_words_of(python_words));
    }
  }
  return {surface.shared(), options};
}

py::array_t<ContactRow> detect(fccda::ContactDetector& detector, const Motion& motion, const py::object& x_t0, const py::object& x_t1,
                               const std::optional<py::object>& radius) {
  py::array at_t0, at_t1, radii;
  const fccda::ConstVectors from = vectors_in(x_t0, "x_t0", at_t0), to = vectors_in(x_t1, "x_t1", at_t1);
  std::optional<fccda::Numbers> of_each;
  if (radius) of_each = each_in(*radius, "radius", radii);
  use_chosen_threads();
  std::vector<fccda::Contact> contacts;
  {
    const py::gil_scoped_release release;
    contacts = of_each ? detector.detect(motion, from, to, *of_each) : detector.detect(motion, from, to);
  }
  return rows_of(contacts);
}

py::array_t<std::int64_t> points_inside(const fccda::ContactDetector& detector, const Pose& pose, const py::object& x,
                                        const std::optional<py::object>& radius) {
  py::array places, radii;
  const fccda::ConstVectors at = vectors_in(x, "x", places);
  const std::vector<std::size_t> inside = radius ? detector.points_inside(pose, at, each_in(*radius, "radius", radii)) : detector.points_inside(pose, at);
  return array_of(inside);
}

fccda::ContactSum respond_to(const py::array_t<ContactRow, py::array::c_style>& contacts, const Motion& motion, RigidBody& body, const py::object& x_t0,
                             const py::array& x_t1, const py::array& velocity, const py::object& mass, double friction, const fccda::ContactDetector* detector,
                             bool apply) {
  if (friction != 0 && !detector)
    throw InputError("friction requires the detector of the contacts, which limits sliding at obstructing panels; pass detector=… to respond.");
  py::array at_t0, masses;
  const fccda::ConstVectors from = vectors_in(x_t0, "x_t0", at_t0);
  const fccda::PointArrays points{
      .x_t0 = from, .x_t1 = writable_vectors_in(x_t1, "x_t1"), .velocity = writable_vectors_in(velocity, "velocity"), .mass = each_in(mass, "mass", masses)};
  const std::vector<fccda::Contact> which = contacts_in(contacts, from.size(), detector);
  return apply ? fccda::respond(which, motion, body, points, friction) : fccda::respond_without_body(which, motion, body, points, friction);
}

void bind_contact(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(ContactRow, point, panel, time_fraction, depth, radius, offset, hit, normal, relocation, normal_t0);
  py::class_<fccda::ContactDetector>(
      module, "ContactDetector",
      R"(Continuous collision detection between points and a moving surface. One detector serves one set of points and caches their distances.

x_t0 of a step must be x_t1 of the previous step, as relocated; report points for which it is not with `moved`. Points may be appended or removed at the end.)")
      .def(py::init(&detector_of), "surface"_a, "radius"_a = 0.0, py::kw_only(), "boxes"_a = py::none(), "clip"_a = false,
           R"(radius: contact radius of the points [m]; 0 for points without extent.
boxes: contact bounds, [(size, centre), …] in the body frame [m]; without them contact is detected everywhere.
clip: whether the surface may extend beyond the bounds, where contact is then not detected; otherwise that raises InputError.)")
      .def("detect", &detect, "motion"_a, "x_t0"_a, "x_t1"_a, "radius"_a = py::none(),
           R"(Detects the contacts of one step, in point order. x_t0, x_t1: (points, 3) world positions at the start and the end of the step [m]; not modified.
radius: contact radius of each point [m], for different radii; it may change from step to step.

Returns a structured array with the fields point, panel (number in the mesh), time_fraction (time of impact, 0 to 1), depth (distance from x_t1 to the
relocation) [m], hit (point of first contact on the surface) [m], normal (outward unit normal), relocation (corrected position of the point) [m], radius
(contact radius of the point) [m], offset (by how much contact is tested nearer than the radius and relocated farther, for positions in float32; 0 for
float64) [m], normal_t0 (surface normal at t0 of a ball in contact there, along which the impulse acts; else 0).)")
      .def("points_inside", &points_inside, "pose"_a, "x"_a, "radius"_a = py::none(),
           "Indices of the points x (points, 3) [m] that are inside the surface or closer than the contact radius (`radius` per point [m] if given); for use "
           "before the first step.")
      .def(
          "moved", [](fccda::ContactDetector& detector, std::size_t point) { detector.moved(point); }, "point"_a,
          "Declares that the point has been displaced since the last step.")
      .def("points_changed", &fccda::ContactDetector::points_changed,
           "Declares that points were renumbered, or many displaced: discards the cached distances.");

  py::class_<fccda::ContactSum>(module, "ContactSum", "Sum of the contacts of a step, acting on the body.")
      .def_readonly("impulse", &fccda::ContactSum::impulse, "(3,) impulse [N s]; divided by dt, the mean force.")
      .def_readonly("angular_impulse", &fccda::ContactSum::angular_impulse, "(3,) angular impulse about the centre of mass [N m s].")
      .def_readonly("contacts", &fccda::ContactSum::contacts, "Number of contacts.");

  module.def("respond", &respond_to, "contacts"_a, "motion"_a, "body"_a, py::kw_only(), "x_t0"_a, "x_t1"_a.noconvert(), "velocity"_a.noconvert(), "mass"_a,
             "friction"_a = 0.0, "detector"_a = py::none(), "apply"_a = true,
             R"(Contact response: relocates the points in contact to the surface, updates their velocities, and applies the impulse to the body.

x_t1 [m] and velocity [m/s], with which the points moved from x_t0 to x_t1, are (points, 3) arrays of float64 or float32, modified in place. mass [kg]: one
number, or one per point. friction: Coulomb friction coefficient. detector: the detector of these contacts, in this step; required with friction, which moves
points along the surface but not through other panels, and advisable without: only with it do balls that slide get impulses that do no work (normal_t0). apply: False leaves the body unchanged, so that the impulses of several sets of points, or of several
processes, can be summed and applied together with add_impulse. Returns the ContactSum.)");
}

}  // namespace

void bind_fccda(py::module_& module) {
  bind_surface(module);
  bind_bodies(module);
  bind_contact(module);
}

}  // namespace perimpact::python
