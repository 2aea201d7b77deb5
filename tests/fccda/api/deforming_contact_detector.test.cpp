#include "fccda/api/deforming_contact_detector.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "fccda/deforming/scenes.hpp"
#include "fixtures/tolerance.hpp"

using namespace deforming;

namespace {

/// A net, held at its border, and points that fall on it. Its vertices move by what they receive.
struct Net {
  Panels panels = sheet(10);
  std::shared_ptr<DeformingSurface> surface = open_surface(panels);
  DeformingContactDetector detector{surface, 0.02};
  std::vector<Vec3d> x = panels.vertices, v = std::vector<Vec3d>(x.size()), impulse = v;
  std::vector<double> mass;
  std::vector<Vec3d> point_t0, point, velocity;
  double dt = 0.01, point_mass = 0.3;

  Net() {
    for (const Vec3d& vertex : x) mass.push_back(std::max(std::fabs(vertex.x), std::fabs(vertex.y)) > 0.49 ? prescribed_motion : 0.2);
    for (int k = 0; k < 25; ++k) point.push_back({0.13 * (k % 5 - 2) + 0.011, 0.13 * (k / 5 - 2) + 0.017, 0.1 + 0.01 * k});
    velocity.assign(point.size(), {0.1, 0, -1});
  }

  std::size_t step() {
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += dt * v[k];
    surface->move(x);
    point_t0 = point;
    for (std::size_t k = 0; k < point.size(); ++k) point[k] += dt * velocity[k];
    const std::vector<DeformingContact> contacts = detector.detect(point_t0, point);
    std::fill(impulse.begin(), impulse.end(), Vec3d{});
    respond(contacts, dt, {point_t0, point, velocity, point_mass}, 0.3, mass, impulse);
    for (std::size_t k = 0; k < x.size(); ++k) v[k] += impulse[k] / mass[k];
    return contacts.size();
  }
};

template <class Exception, class Call>
std::string message(const Call& call) {
  try {
    call();
  } catch (const Exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("deforming contact detector: points that fall on a net push it along, and none falls through") {
  Net net;
  std::size_t contacts = 0;
  Vec3d on_border{};
  const auto momentum = [&] {
    Vec3d sum{};
    for (const Vec3d& velocity : net.velocity) sum += net.point_mass * velocity;
    for (std::size_t k = 0; k < net.x.size(); ++k)
      if (std::isfinite(net.mass[k])) sum += net.mass[k] * net.v[k];
    return sum;
  };
  const Vec3d before = momentum();
  for (int k = 0; k < 60; ++k) {
    contacts += net.step();
    for (std::size_t v = 0; v < net.x.size(); ++v)
      if (!std::isfinite(net.mass[v])) on_border += net.impulse[v];
  }
  CHECK(contacts > 100);
  CHECK(norm(momentum() + on_border - before) == fixtures::absolute(0, 1e-12 * norm(before), "N s"));
  // Each is at least at the contact radius from the net, and above it.
  const Soup soup(net.surface->at_t1());
  for (const Vec3d& x : net.point) {
    CHECK(soup.distance(x) >= 0.02);
    const std::optional<ClosestPoint> closest = net.surface->bvh_t1().closest(x);
    CHECK(dot(x - closest->point, net.surface->at_t1().normal(static_cast<std::size_t>(closest->triangle))) > 0);
  }
}

TEST_CASE("deforming contact detector: a restart from its state continues bitwise") {
  Net net;
  for (int k = 0; k < 25; ++k) net.step();
  Net other;
  for (int k = 0; k < 25; ++k) other.step();
  const ContactDetector::State state = other.detector.state();
  other.surface = open_surface(other.panels);
  other.surface->move(other.x);  // where the vertices are
  other.detector = DeformingContactDetector(other.surface, 0.02);
  other.detector.resume(state);
  for (int k = 0; k < 15; ++k) CHECK(net.step() == other.step());
  CHECK(net.point == other.point);
  CHECK(net.velocity == other.velocity);
  CHECK(net.v == other.v);
}

TEST_CASE("deforming contact detector: points of different radii have the same contacts as the points of each radius alone") {
  Net net;
  const std::vector<double> radii_of_kind{0.01, 0.02, 0.035};
  std::vector<DeformingContactDetector> alone;
  for (const double radius : radii_of_kind) alone.emplace_back(net.surface, radius);
  DeformingContactDetector detector(net.surface);
  std::vector<double> radii;
  for (std::size_t i = 0; i < net.point.size(); ++i) radii.push_back(radii_of_kind[i % 3]);
  std::size_t found = 0;
  for (int k = 0; k < 40; ++k) {
    for (std::size_t v = 0; v < net.x.size(); ++v) net.x[v].z = 0.03 * std::sin(0.4 * k) * (net.x[v].x + net.x[v].y);
    net.surface->move(net.x);
    net.point_t0 = net.point;
    for (std::size_t i = 0; i < net.point.size(); ++i) net.point[i] += net.dt * net.velocity[i];
    const std::vector<DeformingContact> contacts = detector.detect(net.point_t0, net.point, radii);
    std::vector<Contact> expected;
    for (std::size_t kind = 0; kind < 3; ++kind)
      for (const DeformingContact& one : alone[kind].detect(net.point_t0, net.point))
        if (one.contact.point % 3 == kind) expected.push_back(one.contact);
    std::ranges::sort(expected, {}, &Contact::point);
    REQUIRE(contacts.size() == expected.size());
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const Contact &one = contacts[c].contact, &other = expected[c];
      REQUIRE(one.point == other.point);
      CHECK(one.radius == radii[one.point]);
      CHECK(one.relocation == other.relocation);
      CHECK(one.time_fraction == other.time_fraction);
      net.point[one.point] = one.relocation;
    }
    found += contacts.size();
    for (DeformingContactDetector& one : alone) one.points_changed();  // others were relocated with radii other than its own
  }
  CHECK(found > 100);
  CHECK(detector.points_inside(net.point, radii).empty());
  CHECK(detector.points_inside(net.point, 0.2).size() == net.point.size());
}

TEST_CASE("deforming contact detector: a point at rest on a sheet is relocated to its new radius when it grows, and stays when it shrinks") {
  Net net;
  std::vector<Vec3d> x{{0.011, 0.017, 0.05}};
  const auto detect = [&](const Numbers& radius) {
    net.surface->move(net.x);
    const std::vector<Vec3d> x_t0 = x;
    const std::vector<DeformingContact> contacts = net.detector.detect(x_t0, x, radius);
    for (const DeformingContact& one : contacts) x[0] = one.contact.relocation;
    return contacts.size();
  };
  CHECK(detect(0.05) == 0);
  CHECK(detect(0.06) == 1);
  CHECK(x[0].z == fixtures::absolute(0.06, 1e-11, "m"));
  CHECK(detect(0.01) == 0);
  CHECK(x[0].z == fixtures::absolute(0.06, 1e-11, "m"));
  CHECK(message<InputError>([&] { detect(-1.0); }) == "contact: the radius of point 0 is -1 m, but it must be a number of at least 0.");
  const std::vector<double> two{0.1, 0.1};
  CHECK(message<InputError>([&] { detect(two); }) == "contact: the number of radii differs from the 1 points; give one for each, or one number for all.");
}

TEST_CASE("deforming contact detector: what it cannot use it refuses in a sentence") {
  Net net;
  net.surface->move(net.x);
  const std::vector<Vec3d> two{{0, 0, 1}, {0, 0, 2}}, one{{0, 0, 1}}, nowhere{{0, 0, std::numeric_limits<double>::quiet_NaN()}};
  CHECK(message<InputError>([&] { net.detector.detect(two, one); }) ==
        "contact: there are 2 points at the beginning of the step and 1 at its end; give both positions of every point.");
  CHECK(message<RunError>([&] { net.detector.detect(one, nowhere); }) ==
        "contact: point 0 goes from (0, 0, 1) to (0, 0, nan) in one step, which is not finite; the solver has become unstable, use a shorter step.");
  CHECK(message<RunError>([&] { net.detector.points_inside(nowhere); }) == "contact: point 0 is at (0, 0, nan), which is not finite.");
  CHECK(net.detector.points_inside(std::vector<Vec3d>{{0, 0, 0.01}, {0, 0, 1}}) == std::vector<std::size_t>{0});
  CHECK(message<InputError>([&] {
          net.detector.resume({.inside = {3, 2}});
        }) == "contact: the points of a detector's state are not in ascending order; pass what state() returned.");

  std::vector<Vec3d> from{{0.01, 0.02, 0.1}}, to{{0.01, 0.02, -0.1}}, velocity{{0, 0, -20}};
  const std::vector<DeformingContact> contacts = net.detector.detect(from, to);
  REQUIRE(contacts.size() == 1);
  const auto refusal = [&](double dt, double mass, const Numbers& vertex_mass, std::vector<Vec3d>& impulses) {
    return message<InputError>([&] { respond(contacts, dt, {from, to, velocity, mass}, 0, vertex_mass, impulses); });
  };
  std::vector<Vec3d> few(3);
  CHECK(refusal(0, 1, 1.0, net.impulse) == "contact: the step has a duration of 0 s, but velocities need a positive one; pass that of the step.");
  CHECK(refusal(0.01, -1, 1.0, net.impulse) == "contact: the mass of point 0 is -1 kg, but it must be a finite number of at least 0.");
  CHECK(refusal(0.01, 1, 0.0, net.impulse).find(" is 0 kg, but it must be positive; it is infinite where motion is prescribed.") != std::string::npos);
  CHECK(refusal(0.01, 1, net.mass, few) ==
        "contact: the number of masses of vertices differs from the 3 impulses; give one for each vertex of the panels, or one number for all.");
  CHECK(refusal(0.01, 1, 1.0, few).find(", but there are impulses of 3 vertices only; give one for each vertex of the panels.") != std::string::npos);
  CHECK(to[0].z == fixtures::relative(-0.1, 1e-15));  // nothing has changed
  CHECK(refusal(0.01, 1, net.mass, net.impulse).empty());
  CHECK(to[0].z == fixtures::relative(0.02, 1e-9));
}

TEST_CASE("deforming contact detector: impulses that are not finite are refused, and nothing is changed") {
  Net net;
  net.surface->move(net.x);
  std::vector<Vec3d> from{{0.01, 0.02, 0.1}, {0.11, 0.02, 0.1}}, to{{0.01, 0.02, -0.1}, {0.11, 0.02, -0.1}}, velocity{{0, 0, -20}, {0, 0, -1e10}};
  const std::vector<Vec3d> to_before = to, velocity_before = velocity;
  const std::vector<DeformingContact> contacts = net.detector.detect(from, to);
  REQUIRE(contacts.size() == 2);
  const auto refusal = [&](double mass, double vertex_mass, std::vector<Vec3d>& impulses) {
    return message<InputError>([&] { respond(contacts, 0.01, {from, to, velocity, mass}, 0, vertex_mass, impulses); });
  };
  for (const double vertex_mass : {prescribed_motion, 1e-320}) {  // of which the inverse is infinite
    CHECK(refusal(1e305, vertex_mass, net.impulse).find("but it must be finite.") != std::string::npos);
    CHECK((to == to_before && velocity == velocity_before));
    for (const Vec3d& impulse : net.impulse) CHECK(impulse == Vec3d{});
  }
  std::vector<Vec3d> not_cleared(net.impulse.size(), {std::numeric_limits<double>::quiet_NaN(), 0, 0});
  CHECK(refusal(1, 1, not_cleared).starts_with("contact: the impulse on vertex "));
  CHECK(refusal(1, 1, not_cleared).ends_with(" so far is (nan, 0, 0), but it must be finite."));
  CHECK((to == to_before && velocity == velocity_before));
  CHECK(refusal(1, 1, net.impulse).empty());
}

TEST_CASE("deforming contact detector: two contacts of one point are refused") {
  Net net;
  net.surface->move(net.x);
  std::vector<Vec3d> from{{0.01, 0.02, 0.1}}, to{{0.01, 0.02, -0.1}}, velocity{{0, 0, -20}};
  std::vector<DeformingContact> contacts = net.detector.detect(from, to);
  REQUIRE(contacts.size() == 1);
  contacts.push_back(contacts[0]);
  CHECK(message<InputError>([&] {
          respond(contacts, 0.01, {from, to, velocity, 1.0}, 0, 1.0, net.impulse);
        }).starts_with("contact: a contact of point 0 follows one of point 0, but each point may have one contact only"));
  CHECK(velocity[0].z == -20);
}
