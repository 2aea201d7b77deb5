// What the C interface refuses: each with its status and its sentence, and with handles that remain usable.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <thread>

#include "fccda/c/scenes.hpp"
#include "fixtures/surfaces.hpp"

using namespace c_scenes;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// One point above a cube, and all handles.
struct Scene {
  fccda_surface* cube = surface_of(fixtures::unit_cube());
  fccda_detector* detector = nullptr;
  fccda_body* body = nullptr;
  fccda_deforming_surface* soft = nullptr;
  fccda_deforming_detector* soft_detector = nullptr;
  std::vector<double> x_t0{0.5, 0.5, 1.1}, x_t1{0.5, 0.5, 0.9}, v{0, 0, -2}, vertices, impulses;
  std::vector<float> floats{0.5F, 0.5F, 0.9F};
  fccda_points points{fccda_xyz(x_t0.data(), 1), fccda_xyz(x_t1.data(), 1), fccda_xyz(v.data(), 1), fccda_one(1), fccda_unset()};
  fccda_motion rest{fccda_no_pose(), fccda_no_pose(), {0, 0, 0}, 0.1};
  fccda_body_properties properties = fccda_fixed_body(1);
  fccda_pose pose = fccda_no_pose();
  fccda_vectors at{}, onto{}, x{};
  fccda_numbers heavy = fccda_one(HUGE_VAL);
  fccda_body_state state{};
  fccda_surface_info info{};
  fccda_hull hull{};
  fccda_propeller propeller{};
  fccda_box box{{1, 1, 1}, {0.6, 0.5, 0.5}};
  const std::int64_t* list = nullptr;
  const fccda_contact* contacts = nullptr;
  const fccda_deforming_contact* soft_contacts = nullptr;
  fccda_surface* surface = nullptr;
  fccda_detector* other = nullptr;
  fccda_body* other_body = nullptr;
  fccda_deforming_surface* other_soft = nullptr;
  fccda_deforming_detector* other_soft_detector = nullptr;
  std::size_t count = 0;
  double zero[3] = {0, 0, 0}, energy = 0;

  Scene() {
    REQUIRE(fccda_detector_create(cube, 0.01, &detector) == FCCDA_OK);
    REQUIRE(fccda_body_create(&properties, &body) == FCCDA_OK);
    REQUIRE(fccda_deforming_surface_create(cube, &soft) == FCCDA_OK);
    REQUIRE(fccda_deforming_detector_create(soft, 0.01, &soft_detector) == FCCDA_OK);
    for (const Vec3d& vertex : fixtures::unit_cube().vertices) vertices.insert(vertices.end(), {vertex.x, vertex.y, vertex.z});
    impulses.resize(vertices.size());
    at = fccda_xyz(vertices.data(), 8), onto = fccda_xyz(impulses.data(), 8), x = points.x_t1;
    fccda_body_state_of(body, &state);
  }
  Scene(const Scene&) = delete;
  ~Scene() {
    fccda_surface_destroy(cube), fccda_detector_destroy(detector), fccda_body_destroy(body), fccda_deforming_surface_destroy(soft);
    fccda_deforming_detector_destroy(soft_detector);
  }

  /// All handles work: one contact with each surface, and a response to it.
  void expect_usable() {
    x_t1 = {0.5, 0.5, 0.9}, v = {0, 0, -2};
    CHECK(fccda_detector_points_changed(detector) == FCCDA_OK);
    CHECK(fccda_detect(detector, &rest, &points, &count) == FCCDA_OK);
    CHECK(count == 1);
    CHECK(fccda_respond(detector, &rest, &points, 0, body, nullptr) == FCCDA_OK);
    CHECK(x_t1[2] > 1.0099);
    x_t1 = {0.5, 0.5, 0.9}, v = {0, 0, -2};
    CHECK(fccda_deforming_detector_points_changed(soft_detector) == FCCDA_OK);
    CHECK(fccda_deforming_surface_move(soft, &at) == FCCDA_OK);
    CHECK(fccda_deforming_detect(soft_detector, &points, &count) == FCCDA_OK);
    CHECK(count == 1);
    CHECK(fccda_deforming_respond(soft_detector, 0.1, &points, 0, &heavy, &onto, nullptr) == FCCDA_OK);
    CHECK(x_t1[2] > 1.0099);
  }
};

struct Refusal {
  const char* name;
  std::function<fccda_status(Scene&)> call;
  fccda_status status;
  std::string sentence;  // begins with this
};

template <class T>
std::function<fccda_status(Scene&)> with_points(const T& change) {
  return [change](Scene& s) {
    fccda_points points = s.points;
    change(s, points);
    return fccda_detect(s.detector, &s.rest, &points, nullptr);
  };
}

void expect_refused(const Refusal& refusal, Scene& scene) {
  const std::string name = refusal.name;
  CAPTURE(name);
  CHECK(refusal.call(scene) == refusal.status);
  const std::string sentence = fccda_last_error();
  CAPTURE(sentence);
  CHECK(sentence.starts_with(refusal.sentence));
  CHECK(sentence.ends_with('.'));
}

const std::vector<Refusal>& refusals() {
  static const std::vector<Refusal> all{
      {"a file that is not there", [](Scene& s) { return fccda_surface_read("no.stl", nullptr, &s.surface); }, FCCDA_INPUT_ERROR,
       "no.stl: there is no such file"},
      {"panels of five corners",
       [](Scene& s) {
         const std::int32_t panels[] = {0, 1, 2, 3, 4};
         return fccda_surface_create(&s.at, panels, 1, 5, nullptr, &s.surface);
       },
       FCCDA_INPUT_ERROR, "surface: the panels have 5 corners, but they must have 3, or 4"},
      {"a vertex that is not there",
       [](Scene& s) {
         const std::int32_t panels[] = {0, 1, 8};
         return fccda_surface_create(&s.at, panels, 1, 3, nullptr, &s.surface);
       },
       FCCDA_INPUT_ERROR, "surface: "},
      {"an open surface without orientation",
       [](Scene& s) {
         const std::int32_t panels[] = {0, 1, 2};
         return fccda_surface_create(&s.at, panels, 1, 3, nullptr, &s.surface);
       },
       FCCDA_INPUT_ERROR, "surface: "},
      {"an orientation that is none",
       [](Scene& s) {
         const fccda_surface_options options{0, nullptr, 3, 0};
         return fccda_surface_create(&s.at, nullptr, 0, 3, &options, &s.surface);
       },
       FCCDA_INPUT_ERROR, "surface: the orientation is 3, but it must be FCCDA_UNDECLARED"},
      {"a weld distance below zero",
       [](Scene& s) {
         const std::int32_t panels[] = {0, 1, 2};
         const fccda_surface_options options{-1, "net", FCCDA_NORMALS, 0};
         return fccda_surface_create(&s.at, panels, 1, 3, &options, &s.surface);
       },
       FCCDA_INPUT_ERROR, "net: the weld distance is -1, but it must be a finite number of at least 0; 0 merges coincident vertices only."},
      {"a weld distance that is no number",
       [](Scene& s) {
         const std::int32_t panels[] = {0, 1, 2};
         const fccda_surface_options options{nan, "net", FCCDA_NORMALS, 0};
         return fccda_surface_create(&s.at, panels, 1, 3, &options, &s.surface);
       },
       FCCDA_INPUT_ERROR, "net: the weld distance is nan"},
      {"a reserved member of options",
       [](Scene& s) {
         const std::int32_t panels[] = {0, 1, 2};
         const fccda_surface_options options{0, "net", FCCDA_NORMALS, 7};
         return fccda_surface_create(&s.at, panels, 1, 3, &options, &s.surface);
       },
       FCCDA_INPUT_ERROR, "fccda: the member `reserved` of `options` is 7, but it must be 0; set the structure to zero before its members."},
      {"a reserved member of a propeller",
       [](Scene& s) {
         fccda_propeller propeller = s.propeller;
         propeller.reserved = 1;
         return fccda_surface_propeller(&propeller, &s.surface);
       },
       FCCDA_INPUT_ERROR, "fccda: the member `reserved` of `propeller` is 1"},
      {"a reserved member of sectors",
       [](Scene& s) {
         const fccda_sectors sectors{{0, 0, 1}, {0, 0, 0}, 3, 3, 0, 0, 0, 1, 5};
         return fccda_detector_create_in_sectors(s.cube, 0, &sectors, FCCDA_REFUSE_BEYOND, &s.other);
       },
       FCCDA_INPUT_ERROR, "fccda: the member `reserved` of `sectors` is 5"},
      {"a reserved member of vectors", with_points([](Scene&, fccda_points& p) { p.x_t1.reserved = -1; }), FCCDA_INPUT_ERROR,
       "fccda: the member `reserved` of `x_t1` is -1"},
      {"a reserved member of numbers", with_points([](Scene&, fccda_points& p) { p.radius = fccda_one(0.1), p.radius.reserved = 2; }), FCCDA_INPUT_ERROR,
       "fccda: the member `reserved` of `radius` is 2"},
      {"sectors with an angle that is no number",
       [](Scene& s) {
         const fccda_sectors sectors{{0, 0, 1}, {0, 0, 0}, 3, 3, 0, nan, 0, 1, 0};
         return fccda_detector_create_in_sectors(s.cube, 0, &sectors, FCCDA_IGNORE_BEYOND, &s.other);
       },
       FCCDA_INPUT_ERROR, "contact bounds: the angle of the cylinder's sectors is nan rad"},
      {"a box with a centre that is no number",
       [](Scene& s) {
         const fccda_box box{{1, 1, 1}, {0, nan, 0}};
         return fccda_detector_create_in_boxes(s.cube, 0, &box, 1, FCCDA_IGNORE_BEYOND, &s.other);
       },
       FCCDA_INPUT_ERROR, "contact bounds: the centre of the box is (0, nan, 0), but it must be finite."},
      {"a closed surface whose outside is inside",
       [](Scene& s) {
         const std::int32_t panels[] = {0, 2, 1, 0, 1, 4, 1, 2, 4, 2, 0, 4};
         const fccda_surface_options options{0, "tank", FCCDA_REVERSED, 0};
         return fccda_surface_create(&s.at, panels, 4, 3, &options, &s.surface);
       },
       FCCDA_INPUT_ERROR, "tank: the surface is closed, so its outside is known"},
      {"no panels", [](Scene& s) { return fccda_surface_create(&s.at, nullptr, 0, 3, nullptr, &s.surface); }, FCCDA_INPUT_ERROR, "surface: "},
      {"a sphere without size", [](Scene& s) { return fccda_surface_sphere(-1, 0, &s.surface); }, FCCDA_INPUT_ERROR, "sphere: "},
      {"an axis that is none", [](Scene& s) { return fccda_surface_cylinder(1, 1, 3, 0, &s.surface); }, FCCDA_INPUT_ERROR, "cylinder: the axis is 3"},
      {"a hull without length", [](Scene& s) { return fccda_surface_hull(&s.hull, &s.surface); }, FCCDA_INPUT_ERROR, "hull: "},
      {"a propeller of one blade", [](Scene& s) { return fccda_surface_propeller(&s.propeller, &s.surface); }, FCCDA_INPUT_ERROR, "propeller: "},
      {"a propeller along an axis that is none",
       [](Scene& s) {
         fccda_propeller propeller = s.propeller;
         propeller.axis = -1;
         return fccda_surface_propeller(&propeller, &s.surface);
       },
       FCCDA_INPUT_ERROR, "propeller: the axis is -1, but it must be 0, 1 or 2"},
      {"no boxes", [](Scene& s) { return fccda_detector_create_in_boxes(s.cube, 0, &s.box, 0, FCCDA_REFUSE_BEYOND, &s.other); }, FCCDA_INPUT_ERROR,
       "contact bounds: no boxes are given"},
      {"a box that the surface exceeds", [](Scene& s) { return fccda_detector_create_in_boxes(s.cube, 0, &s.box, 1, FCCDA_REFUSE_BEYOND, &s.other); },
       FCCDA_INPUT_ERROR,
       "contact bounds: 5 of 6 panels extend beyond the box by up to 0.1 m (panels 0, 1, 2, 3, 4), and contact there would be missed; enlarge the box, or pass "
       "FCCDA_IGNORE_BEYOND if this is intended."},
      {"a treatment of panels beyond that is none", [](Scene& s) { return fccda_detector_create_in_boxes(s.cube, 0, &s.box, 1, 2, &s.other); },
       FCCDA_INPUT_ERROR, "contact bounds: the treatment of panels beyond them is 2, but it must be FCCDA_REFUSE_BEYOND or FCCDA_IGNORE_BEYOND."},
      {"sectors without radius",
       [](Scene& s) {
         const fccda_sectors sectors{{0, 0, 1}, {0, 0, 0}, 0, 1, 0, 0, 0, 1, 0};
         return fccda_detector_create_in_sectors(s.cube, 0, &sectors, FCCDA_REFUSE_BEYOND, &s.other);
       },
       FCCDA_INPUT_ERROR, "contact bounds: "},
      {"a ball with a radius below zero",
       [](Scene& s) {
         const fccda_numbers radius = fccda_one(-1);
         return fccda_deforming_detector_balls_inside(s.soft_detector, &s.x, &radius, &s.list, &s.count);
       },
       FCCDA_INPUT_ERROR, "contact: the contact radius is -1 m"},
      {"too little space for vertices",
       [](Scene& s) {
         const fccda_vectors less = fccda_xyz(s.vertices.data(), 7);
         return fccda_surface_vertices(s.cube, &less);
       },
       FCCDA_INPUT_ERROR, "surface: the array has space for 7 vertices, but the surface has 8"},
      {"too little space for panels",
       [](Scene& s) {
         std::int32_t panels[4];
         return fccda_surface_panels(s.cube, panels, 1);
       },
       FCCDA_INPUT_ERROR, "surface: the array has space for 1 panels, but the surface has 6"},
      {"a negative radius", [](Scene& s) { return fccda_detector_create(s.cube, -1, &s.other); }, FCCDA_INPUT_ERROR, "contact: the contact radius is -1 m"},
      {"a radius that is no number", [](Scene& s) { return fccda_deforming_detector_create(s.soft, nan, &s.other_soft_detector); }, FCCDA_INPUT_ERROR,
       "contact: "},
      {"an array that is NULL", with_points([](Scene&, fccda_points& p) { p.x_t0.y = nullptr; }), FCCDA_INPUT_ERROR,
       "fccda: the array `x_t0` of 1 elements is NULL"},
      {"a view without type", with_points([](Scene&, fccda_points& p) { p.x_t1 = {}; }), FCCDA_INPUT_ERROR,
       "fccda: the array `x_t1` has the type 0, but it must be FCCDA_DOUBLE or FCCDA_FLOAT."},
      {"one vector for all", with_points([](Scene&, fccda_points& p) { p.x_t1.type = FCCDA_ONE; }), FCCDA_INPUT_ERROR,
       "fccda: the array `x_t1` has the type 3"},
      {"a stride in numbers", with_points([](Scene&, fccda_points& p) { p.x_t1.stride = 3; }), FCCDA_INPUT_ERROR,
       "fccda: the array `x_t1` has a stride of 3 bytes"},
      {"doubles at the address of floats", with_points([](Scene& s, fccda_points& p) { p.x_t0.x = reinterpret_cast<char*>(s.x_t0.data()) + 4; }),
       FCCDA_INPUT_ERROR, "fccda: the array `x_t0` has a stride of 24 bytes or an address"},
      {"fewer points at the end", with_points([](Scene&, fccda_points& p) { p.x_t1.count = 0; }), FCCDA_INPUT_ERROR,
       "contact: there are 1 points at the beginning of the step and 0 at its end"},
      {"radii of no type", with_points([](Scene&, fccda_points& p) { p.radius.type = 7; }), FCCDA_INPUT_ERROR, "fccda: the array `radius` has the type 7"},
      {"a radius below zero", with_points([](Scene&, fccda_points& p) { p.radius = fccda_one(-0.1); }), FCCDA_INPUT_ERROR,
       "contact: the radius of point 0 is -0.1 m"},
      {"a position that is no number", with_points([](Scene& s, fccda_points&) { s.x_t1[0] = nan; }), FCCDA_RUN_ERROR, "contact: point 0 goes from"},
      {"a point that is far too fast", with_points([](Scene& s, fccda_points&) { s.x_t1[0] = 1e9; }), FCCDA_RUN_ERROR, "contact: point 0 goes from"},
      {"a pose that is none",
       [](Scene& s) {
         fccda_motion motion = s.rest;
         motion.t1.attitude[0] = 2;
         return fccda_detect(s.detector, &motion, &s.points, nullptr);
       },
       FCCDA_INPUT_ERROR, "motion at t1: the attitude of the pose is a quaternion of length 2"},
      {"a response without velocities",
       [](Scene& s) {
         fccda_points points = s.points;
         points.velocity = {};
         return fccda_respond(s.detector, &s.rest, &points, 0, s.body, nullptr);
       },
       FCCDA_INPUT_ERROR, "fccda: the array `velocity` has the type 0"},
      {"a response without masses",
       [](Scene& s) {
         fccda_points points = s.points;
         points.mass = fccda_unset();
         return fccda_respond(s.detector, &s.rest, &points, 0, s.body, nullptr);
       },
       FCCDA_INPUT_ERROR, "fccda: the array `mass` has the type 0, but it must be FCCDA_DOUBLE, FCCDA_FLOAT or FCCDA_ONE."},
      {"friction below zero", [](Scene& s) { return fccda_respond(s.detector, &s.rest, &s.points, -1, s.body, nullptr); }, FCCDA_INPUT_ERROR,
       "contact: the friction coefficient is -1"},
      {"a step without duration",
       [](Scene& s) {
         fccda_motion motion = s.rest;
         motion.dt = 0;
         return fccda_respond(s.detector, &motion, &s.points, 0, nullptr, nullptr);
       },
       FCCDA_INPUT_ERROR, "contact: the step of the motion has no duration"},
      {"a contact that was not found",
       [](Scene& s) {
         const std::int64_t which = 5;
         return fccda_detector_keep(s.detector, &which, 1);
       },
       FCCDA_INPUT_ERROR, "fccda: contact 5 is to be kept, but the last detection found"},
      {"a point below zero", [](Scene& s) { return fccda_detector_moved(s.detector, -1); }, FCCDA_INPUT_ERROR, "fccda: the number of a point is -1"},
      {"a state that is too short",
       [](Scene& s) {
         const std::int64_t state[] = {0, 0, 1};
         return fccda_detector_resume(s.detector, state, 3);
       },
       FCCDA_INPUT_ERROR, "fccda: these 3 numbers are not the state of a detector"},
      {"a state out of order",
       [](Scene& s) {
         const std::int64_t state[] = {0, 0, 2, 5, 4};
         return fccda_deforming_detector_resume(s.soft_detector, state, 5);
       },
       FCCDA_INPUT_ERROR, "contact: the points of a detector's state are not in ascending order"},
      {"a body without mass",
       [](Scene& s) {
         const fccda_body_properties none = fccda_fixed_body(0);
         return fccda_body_create(&none, &s.other_body);
       },
       FCCDA_INPUT_ERROR, "rigid body: "},
      {"a body without attitude",
       [](Scene& s) {
         const fccda_body_properties zero{.mass = 1};
         return fccda_body_create(&zero, &s.other_body);
       },
       FCCDA_INPUT_ERROR, "rigid body: "},
      {"a step back in time", [](Scene& s) { return fccda_body_advance(s.body, -1, &s.rest); }, FCCDA_INPUT_ERROR, "rigid body: "},
      {"an impulse that is no number",
       [](Scene& s) {
         const double impulse[] = {0, nan, 0};
         return fccda_body_add_impulse(s.body, impulse, s.zero);
       },
       FCCDA_INPUT_ERROR, "rigid body: "},
      {"a seventh degree of freedom", [](Scene& s) { return fccda_body_drive(s.body, 6, 1); }, FCCDA_INPUT_ERROR,
       "rigid body: there is no degree of freedom 6"},
      {"a state of a body that is no number",
       [](Scene& s) {
         fccda_body_state state = s.state;
         state.velocity[1] = nan;
         return fccda_body_resume(s.body, &state);
       },
       FCCDA_INPUT_ERROR, "rigid body: the velocity of the state"},
      {"a state of a body without attitude",
       [](Scene& s) {
         fccda_body_state state = s.state;
         state.attitude[0] = 0;
         return fccda_body_resume(s.body, &state);
       },
       FCCDA_INPUT_ERROR, "rigid body: in the state "},
      {"fewer vertices",
       [](Scene& s) {
         const fccda_vectors less = fccda_xyz(s.vertices.data(), 7);
         return fccda_deforming_surface_move(s.soft, &less);
       },
       FCCDA_INPUT_ERROR, "deforming surface: "},
      {"a vertex that is no number",
       [](Scene& s) {
         std::vector<double> vertices = s.vertices;
         vertices[4] = nan;
         const fccda_vectors at = fccda_xyz(vertices.data(), 8);
         return fccda_deforming_surface_move(s.soft, &at);
       },
       FCCDA_RUN_ERROR, "deforming surface: vertex 1 goes from"},
      {"a velocity that is no number",
       [](Scene& s) {
         CHECK(fccda_detect(s.detector, &s.rest, &s.points, nullptr) == FCCDA_OK);
         s.v[2] = nan;
         return fccda_respond(s.detector, &s.rest, &s.points, 0, s.body, nullptr);
       },
       FCCDA_RUN_ERROR, "contact: the velocity of point 0 is (0, 0, nan), which is not finite"},
      {"a second detection without a move",
       [](Scene& s) {
         CHECK(fccda_deforming_surface_move(s.soft, &s.at) == FCCDA_OK);
         CHECK(fccda_deforming_detect(s.soft_detector, &s.points, nullptr) == FCCDA_OK);
         return fccda_deforming_detect(s.soft_detector, &s.points, nullptr);
       },
       FCCDA_INPUT_ERROR, "contact: the deforming surface was not moved since the last detection"},
      {"a radius below zero at a deforming surface",
       [](Scene& s) {
         fccda_points points = s.points;
         points.radius = fccda_one(-0.01);
         return fccda_deforming_detect(s.soft_detector, &points, nullptr);
       },
       FCCDA_INPUT_ERROR, "contact: the radius of point 0 is -0.01 m"},
      {"a deforming step without duration", [](Scene& s) { return fccda_deforming_respond(s.soft_detector, 0, &s.points, 0, &s.heavy, &s.onto, nullptr); },
       FCCDA_INPUT_ERROR, "contact: the step has a duration of 0 s"},
      {"masses of other vertices",
       [](Scene& s) {
         const fccda_numbers less = fccda_each(s.vertices.data(), 7);
         return fccda_deforming_respond(s.soft_detector, 0.1, &s.points, 0, &less, &s.onto, nullptr);
       },
       FCCDA_INPUT_ERROR, "contact: the number of masses of vertices differs"},
      {"no thread", [](Scene&) { return fccda_use_threads(0); }, FCCDA_INPUT_ERROR, "fccda: the number of threads is 0"}};
  return all;
}

}  // namespace

TEST_CASE("C interface: what cannot be used is refused with its status and sentence, and all handles work afterwards") {
  for (const Refusal& refusal : refusals()) {
    Scene scene;
    expect_refused(refusal, scene);
    CHECK(scene.surface == nullptr);
    CHECK(scene.other == nullptr);
    CHECK(scene.other_body == nullptr);
    scene.expect_usable();
  }
}

TEST_CASE("C interface: an open surface is refused with the remedy in the words of C, and accepted with it") {
  Scene s;
  const std::int32_t panels[] = {0, 1, 2};
  CHECK(fccda_surface_create(&s.at, panels, 1, 3, nullptr, &s.surface) == FCCDA_INPUT_ERROR);
  CHECK(std::string(fccda_last_error()).find("with the orientation of fccda_surface_options, FCCDA_NORMALS") != std::string::npos);
  const fccda_surface_options upward{0, nullptr, FCCDA_NORMALS, 0};
  CHECK(fccda_surface_create(&s.at, panels, 1, 3, &upward, &s.surface) == FCCDA_OK);
  fccda_surface_destroy(s.surface);
  const fccda_surface_options named{0, "keel", FCCDA_UNDECLARED, 0};
  CHECK(fccda_surface_create(&s.at, panels, 1, 3, &named, &s.surface) == FCCDA_INPUT_ERROR);
  CHECK(std::string(fccda_last_error()).starts_with("keel: "));
}

TEST_CASE("C interface: NULL is refused wherever it is no choice, by the name of the argument") {
  Scene s;
  const std::int32_t panel[] = {0, 1, 2};
  const char* text = nullptr;
  const std::vector<std::pair<const char*, fccda_status>> refused{
      {"path", fccda_surface_read(nullptr, nullptr, &s.surface)},
      {"surface", fccda_surface_read("a.stl", nullptr, nullptr)},
      {"surface", fccda_surface_create(&s.at, panel, 1, 3, nullptr, nullptr)},
      {"vertices", fccda_surface_create(nullptr, panel, 1, 3, nullptr, &s.surface)},
      {"panels", fccda_surface_create(&s.at, nullptr, 1, 3, nullptr, &s.surface)},
      {"size", fccda_surface_box(nullptr, 0, &s.surface)},
      {"surface", fccda_surface_sphere(1, 0, nullptr)},
      {"surface", fccda_surface_cylinder(1, 1, 0, 0, nullptr)},
      {"hull", fccda_surface_hull(nullptr, &s.surface)},
      {"propeller", fccda_surface_propeller(nullptr, &s.surface)},
      {"surface", fccda_surface_measure(nullptr, &s.info)},
      {"info", fccda_surface_measure(s.cube, nullptr)},
      {"surface", fccda_surface_vertices(nullptr, &s.at)},
      {"vertices", fccda_surface_vertices(s.cube, nullptr)},
      {"panels", fccda_surface_panels(s.cube, nullptr, 6)},
      {"properties", fccda_body_create(nullptr, &s.other_body)},
      {"body", fccda_body_create(&s.properties, nullptr)},
      {"body", fccda_body_advance(nullptr, 1, &s.rest)},
      {"motion", fccda_body_advance(s.body, 1, nullptr)},
      {"body", fccda_body_add_impulse(nullptr, s.zero, s.zero)},
      {"impulse", fccda_body_add_impulse(s.body, nullptr, s.zero)},
      {"angular_impulse", fccda_body_add_impulse(s.body, s.zero, nullptr)},
      {"body", fccda_body_drive(nullptr, 0, 1)},
      {"body", fccda_body_pose(nullptr, &s.pose)},
      {"pose", fccda_body_pose(s.body, nullptr)},
      {"energy", fccda_body_kinetic_energy(s.body, nullptr)},
      {"state", fccda_body_state_of(s.body, nullptr)},
      {"state", fccda_body_resume(s.body, nullptr)},
      {"body", fccda_body_resume(nullptr, &s.state)},
      {"surface", fccda_detector_create(nullptr, 0, &s.other)},
      {"detector", fccda_detector_create(s.cube, 0, nullptr)},
      {"boxes", fccda_detector_create_in_boxes(s.cube, 0, nullptr, 1, FCCDA_REFUSE_BEYOND, &s.other)},
      {"sectors", fccda_detector_create_in_sectors(s.cube, 0, nullptr, FCCDA_REFUSE_BEYOND, &s.other)},
      {"surface", fccda_detector_create_in_fitted_bounds(nullptr, 0, &s.other)},
      {"detector", fccda_detect(nullptr, &s.rest, &s.points, nullptr)},
      {"motion", fccda_detect(s.detector, nullptr, &s.points, nullptr)},
      {"points", fccda_detect(s.detector, &s.rest, nullptr, nullptr)},
      {"detector", fccda_detector_contacts(nullptr, &s.contacts, &s.count)},
      {"count", fccda_detector_contacts(s.detector, &s.contacts, nullptr)},
      {"detector", fccda_detector_keep(nullptr, s.list, 0)},
      {"which", fccda_detector_keep(s.detector, nullptr, 1)},
      {"detector", fccda_respond(nullptr, &s.rest, &s.points, 0, s.body, nullptr)},
      {"motion", fccda_respond(s.detector, nullptr, &s.points, 0, s.body, nullptr)},
      {"points", fccda_respond(s.detector, &s.rest, nullptr, 0, s.body, nullptr)},
      {"detector", fccda_detector_moved(nullptr, 0)},
      {"detector", fccda_detector_points_changed(nullptr)},
      {"pose", fccda_detector_points_inside(s.detector, nullptr, &s.x, nullptr, &s.list, &s.count)},
      {"x", fccda_detector_points_inside(s.detector, &s.pose, nullptr, nullptr, &s.list, &s.count)},
      {"detector", fccda_detector_state(nullptr, &s.list, &s.count)},
      {"numbers", fccda_detector_resume(s.detector, nullptr, 3)},
      {"surface", fccda_deforming_surface_create(nullptr, &s.other_soft)},
      {"deforming", fccda_deforming_surface_create(s.cube, nullptr)},
      {"surface", fccda_deforming_surface_move(nullptr, &s.at)},
      {"vertices", fccda_deforming_surface_move(s.soft, nullptr)},
      {"surface", fccda_deforming_surface_place(nullptr, &s.at)},
      {"vertices", fccda_deforming_surface_place(s.soft, nullptr)},
      {"surface", fccda_deforming_surface_warnings(nullptr, &text)},
      {"text", fccda_deforming_surface_warnings(s.soft, nullptr)},
      {"surface", fccda_deforming_detector_create(nullptr, 0, &s.other_soft_detector)},
      {"detector", fccda_deforming_detect(nullptr, &s.points, nullptr)},
      {"points", fccda_deforming_detect(s.soft_detector, nullptr, nullptr)},
      {"detector", fccda_deforming_detector_contacts(nullptr, &s.soft_contacts, &s.count)},
      {"points", fccda_deforming_respond(s.soft_detector, 1, nullptr, 0, &s.heavy, &s.onto, nullptr)},
      {"vertex_mass", fccda_deforming_respond(s.soft_detector, 1, &s.points, 0, nullptr, &s.onto, nullptr)},
      {"vertex_impulses", fccda_deforming_respond(s.soft_detector, 1, &s.points, 0, &s.heavy, nullptr, nullptr)},
      {"x", fccda_deforming_detector_points_inside(s.soft_detector, nullptr, &s.list, &s.count)},
      {"radius", fccda_deforming_detector_balls_inside(s.soft_detector, &s.x, nullptr, &s.list, &s.count)}};
  for (const auto& call : refused) {
    CAPTURE(call.first);
    CHECK(call.second == FCCDA_INPUT_ERROR);
  }
  CHECK(fccda_detect(s.detector, nullptr, &s.points, nullptr) == FCCDA_INPUT_ERROR);
  CHECK(std::string(fccda_last_error()) == "fccda: the argument `motion` is NULL, but it is needed; pass its address.");
  CHECK(fccda_surface_report(nullptr) == nullptr);
  fccda_surface_destroy(nullptr), fccda_body_destroy(nullptr), fccda_detector_destroy(nullptr);
  fccda_deforming_surface_destroy(nullptr), fccda_deforming_detector_destroy(nullptr);
  s.expect_usable();
}

TEST_CASE("C interface: after a detection that failed nothing is left to respond to") {
  Scene s;
  CHECK(fccda_detect(s.detector, &s.rest, &s.points, &s.count) == FCCDA_OK);
  REQUIRE(s.count == 1);
  s.x_t1[0] = nan;
  CHECK(fccda_detect(s.detector, &s.rest, &s.points, nullptr) == FCCDA_RUN_ERROR);
  fccda_contact_sum sum{};
  CHECK(fccda_respond(s.detector, &s.rest, &s.points, 0, s.body, &sum) == FCCDA_OK);
  CHECK(sum.contacts == 0);
}

TEST_CASE("C interface: threads have last errors of their own") {
  CHECK(fccda_body_drive(nullptr, 6, 1) == FCCDA_INPUT_ERROR);
  const std::string ours = fccda_last_error();
  std::string at_first, theirs;
  std::thread([&] {
    at_first = fccda_last_error();
    fccda_use_threads(-3);
    theirs = fccda_last_error();
  }).join();
  CHECK(at_first.empty());
  CHECK(theirs.starts_with("fccda: the number of threads is -3"));
  CHECK(ours.starts_with("rigid body: there is no degree of freedom 6"));
  CHECK(fccda_last_error() == ours);
}
