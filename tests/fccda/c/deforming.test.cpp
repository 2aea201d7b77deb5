#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "fccda/api/deforming_contact_detector.hpp"
#include "fccda/c/scenes.hpp"
#include "fccda/deforming/scenes.hpp"
#include "fccda/deforming/step_warnings.hpp"

using namespace c_scenes;

namespace {

constexpr double dt = 0.005, radius = 0.02;
constexpr fccda_surface_options upward{0, nullptr, FCCDA_NORMALS, 0};

/// Vertices on springs to where they began; those of the border are held.
struct Net {
  std::vector<Vec3d> start = deforming::sheet(12).vertices, x = start, v = std::vector<Vec3d>(x.size()), impulse = v;
  std::vector<double> mass;

  Net() {
    for (const Vec3d& vertex : start) mass.push_back(std::fmax(std::fabs(vertex.x), std::fabs(vertex.y)) > 0.49 ? prescribed_motion : 0.05);
  }
  void move() {
    for (std::size_t k = 0; k < x.size(); ++k) {
      v[k] += impulse[k] / mass[k];
      if (std::isfinite(mass[k])) v[k] -= dt * 400.0 * (x[k] - start[k]);
      x[k] += dt * v[k];
      impulse[k] = {};
    }
  }
};

struct CNet {
  fccda_deforming_surface* net = nullptr;
  fccda_deforming_detector* detector = nullptr;

  CNet() {
    fccda_surface* surface = surface_of(deforming::sheet(12), &upward);
    REQUIRE(fccda_deforming_surface_create(surface, &net) == FCCDA_OK);
    REQUIRE(fccda_deforming_detector_create(net, radius, &detector) == FCCDA_OK);
    fccda_surface_destroy(surface);
  }
  CNet(const CNet&) = delete;
  ~CNet() { fccda_deforming_surface_destroy(net), fccda_deforming_detector_destroy(detector); }

  void move(std::vector<Vec3d>& vertices) const {
    const fccda_vectors view = fccda_xyz(&vertices[0].x, vertices.size());
    REQUIRE(fccda_deforming_surface_move(net, &view) == FCCDA_OK);
  }
};

bool same(const DeformingContact& a, const fccda_deforming_contact& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.place.vertices[k] != b.vertices[k] || a.place.weights[k] != b.weights[k]) return false;
  return c_scenes::same(a.contact, b.contact) && a.place.displacement == as_vector(b.displacement);
}

template <class Number>
void compare(const Layout& layout) {
  const std::string where = layout.name;
  CAPTURE(where);
  CAPTURE(sizeof(Number));
  Cloud<Number> ours(layout, {-0.45, -0.45, 0.05}, {0.45, 0.45, 0.8}), theirs = ours;
  Net net, c_net;
  const auto surface = std::make_shared<DeformingSurface>(Surface(deforming::sheet(12), {.orientation = Orientation::normals}));
  DeformingContactDetector detector(surface, radius);
  CNet c;
  const fccda_points points = theirs.c_points(false);
  const fccda_numbers masses = fccda_each(c_net.mass.data(), c_net.mass.size());
  const fccda_vectors impulses = fccda_xyz(&c_net.impulse[0].x, c_net.impulse.size());
  std::size_t all = 0;
  for (int step = 0; step < 80; ++step) {
    ours.move(dt), theirs.move(dt);
    net.move(), c_net.move();
    surface->move(net.x);
    c.move(c_net.x);
    const PointArrays arrays = ours.points();
    const std::vector<DeformingContact> contacts = detector.detect(arrays.x_t0, arrays.x_t1);
    const ContactSum sum = respond(contacts, dt, arrays, 0.3, net.mass, net.impulse);

    std::size_t number = 0;
    const fccda_deforming_contact* first = nullptr;
    fccda_contact_sum c_sum{};
    REQUIRE(fccda_deforming_detect(c.detector, &points, nullptr) == FCCDA_OK);
    REQUIRE(fccda_deforming_detector_contacts(c.detector, &first, &number) == FCCDA_OK);
    REQUIRE(number == contacts.size());
    for (std::size_t k = 0; k < number; ++k) CHECK(same(contacts[k], first[k]));
    REQUIRE(fccda_deforming_respond(c.detector, dt, &points, 0.3, &masses, &impulses, &c_sum) == FCCDA_OK);
    CHECK(c_scenes::same(sum, c_sum));
    REQUIRE(net.impulse == c_net.impulse);
    REQUIRE(std::memcmp(ours.numbers.data(), theirs.numbers.data(), ours.numbers.size() * sizeof(Number)) == 0);
    all += number;
  }
  CHECK(all > 1000);
}

}  // namespace

TEST_CASE("C interface: a net that points push away has the contacts and impulses of C++ bit for bit, for every layout of arrays") {
  for (const Layout& layout : layouts()) {
    compare<double>(layout);
    compare<float>(layout);
  }
}

TEST_CASE("C interface: a deforming run that is resumed continues bitwise, kept contacts alone are answered, and points inside are listed") {
  Cloud<double> cloud(layouts()[0], {-0.45, -0.45, 0.03}, {0.45, 0.45, 0.1});
  Net net;
  CNet first, second;
  const fccda_points points = cloud.c_points(false);
  const fccda_numbers heavy = fccda_one(std::numeric_limits<double>::infinity());
  const fccda_vectors impulses = fccda_xyz(&net.impulse[0].x, net.impulse.size()), x = cloud.c_vectors(cloud.layout.x_t1);
  const auto inside = [&] {
    const std::int64_t* which = nullptr;
    std::size_t number = 0;
    CHECK(fccda_deforming_detector_points_inside(first.detector, &x, &which, &number) == FCCDA_OK);
    return number;
  };
  CHECK(inside() == 0);
  std::size_t number = 0;
  for (int step = 0; number < 20 && step < 40; ++step) {
    cloud.move(dt);
    first.move(net.x);
    CHECK(fccda_deforming_detect(first.detector, &points, &number) == FCCDA_OK);
    if (number < 20) {
      CHECK(fccda_deforming_respond(first.detector, dt, &points, 0, &heavy, &impulses, nullptr) == FCCDA_OK);
    }
  }
  REQUIRE(number >= 20);
  CHECK(inside() == number);
  const std::int64_t kept[] = {2, 3};
  fccda_contact_sum sum{};
  CHECK(fccda_deforming_detector_keep(first.detector, kept, 2) == FCCDA_OK);
  CHECK(fccda_deforming_respond(first.detector, dt, &points, 0, &heavy, &impulses, &sum) == FCCDA_OK);
  CHECK(sum.contacts == 2);
  CHECK(inside() == number - 2);

  // an open surface records which points were in contact: the restart needs the state
  const std::int64_t* numbers = nullptr;
  std::size_t length = 0;
  CHECK(fccda_deforming_detector_state(first.detector, &numbers, &length) == FCCDA_OK);
  CHECK(length > 3);
  CHECK(fccda_deforming_detector_resume(second.detector, numbers, length) == FCCDA_OK);
  const std::vector<std::int64_t> state(numbers, numbers + length);
  CHECK(fccda_deforming_detector_state(second.detector, &numbers, &length) == FCCDA_OK);
  CHECK(std::vector<std::int64_t>(numbers, numbers + length) == state);
  cloud.move(dt);
  std::size_t of_second = 0;
  for (const CNet* each : {&first, &second}) each->move(net.x);
  CHECK(fccda_deforming_detector_moved(first.detector, 0) == FCCDA_OK);
  CHECK(fccda_deforming_detect(first.detector, &points, &number) == FCCDA_OK);
  CHECK(fccda_deforming_detect(second.detector, &points, &of_second) == FCCDA_OK);
  CHECK(number == of_second);
  CHECK(fccda_deforming_detector_points_changed(first.detector) == FCCDA_OK);
}

TEST_CASE("C interface: a rejected step of a net is taken back by placing the net and resuming the detector, and the next step is bitwise the same") {
  Cloud<double> ours(layouts()[0], {-0.45, -0.45, 0.03}, {0.45, 0.45, 0.3}), theirs = ours;
  CNet accepted, tried;
  Net net;
  const fccda_numbers heavy = fccda_one(std::numeric_limits<double>::infinity());
  const fccda_vectors impulses = fccda_xyz(&net.impulse[0].x, net.impulse.size());
  std::size_t all = 0, of_trials = 0;
  const auto step = [&](const CNet& of, std::vector<Vec3d>& vertices, Cloud<double>& cloud) {
    of.move(vertices);
    cloud.move(dt);
    const fccda_points points = cloud.c_points(false);
    std::size_t number = 0;
    CHECK(fccda_deforming_detect(of.detector, &points, &number) == FCCDA_OK);
    CHECK(fccda_deforming_respond(of.detector, dt, &points, 0.2, &heavy, &impulses, nullptr) == FCCDA_OK);
    return number;
  };
  for (int k = 0; k < 60; ++k) {
    std::vector<Vec3d> before = net.x;
    for (std::size_t v = 0; v < net.x.size(); ++v) net.x[v].z = 0.03 * std::sin(0.3 * k) * (1 + net.x[v].x);
    all += step(accepted, net.x, ours);

    // a step that goes elsewhere, and is rejected
    const std::int64_t* numbers = nullptr;
    std::size_t length = 0;
    CHECK(fccda_deforming_detector_state(tried.detector, &numbers, &length) == FCCDA_OK);
    const std::vector<std::int64_t> state(numbers, numbers + length);
    std::vector<Vec3d> elsewhere = before;
    for (Vec3d& x : elsewhere) x.z += 0.2;
    Cloud<double> trial = theirs;
    of_trials += step(tried, elsewhere, trial);
    const fccda_vectors back = fccda_xyz(&before[0].x, before.size());
    CHECK(fccda_deforming_surface_place(tried.net, &back) == FCCDA_OK);
    CHECK(fccda_deforming_detector_resume(tried.detector, state.data(), state.size()) == FCCDA_OK);

    step(tried, net.x, theirs);
    REQUIRE(std::memcmp(ours.numbers.data(), theirs.numbers.data(), ours.numbers.size() * sizeof(double)) == 0);
  }
  CHECK(all > 1000);
  CHECK(of_trials > 1000);
}

TEST_CASE("C interface: warnings about a step of a deforming surface are those of C++, a line for each") {
  Net net;
  CNet c;
  std::vector<Vec3d> to = net.x;
  c.move(to);
  const char* text = nullptr;
  CHECK(fccda_deforming_surface_warnings(c.net, &text) == FCCDA_OK);
  CHECK(std::string(text).empty());
  for (Vec3d& x : to) x.z += 1;
  c.move(to);
  CHECK(fccda_deforming_surface_warnings(c.net, &text) == FCCDA_OK);
  DeformingSurface surface(Surface(deforming::sheet(12), {.orientation = Orientation::normals}));
  surface.move(net.x), surface.move(to);
  REQUIRE(step_warnings(surface).size() == 1);
  CHECK(std::string(text) == step_warnings(surface)[0] + '\n');
}
