#include "fccda/respond/gauge.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"
#include "fccda/detect/scene.hpp"
#include "fccda/respond/respond.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;
using fixtures::detect;

namespace {

constexpr FreeDegrees all_free{{true, true, true, true, true, true}};

Vec3d sum_of(std::span<const Gauge> gauges, Vec3d Gauge::Reading::*what) {
  Vec3d sum;
  for (const Gauge& gauge : gauges) sum += gauge.reading().*what;
  return sum;
}

/// Contact of points at rest with a cylinder that moves and turns through them, and its gauges.
struct Shower {
  std::shared_ptr<const Surface> surface = fixtures::surface_of(fixtures::cylinder());
  RigidBody body{{.mass = 30, .centre_of_mass = {0.05, 0, 0.02}, .inertia = Mat3::diagonal({2, 4, 5})}, Pose({1, 2, 3}), {2, 1, 4}, {5, -3, 10}, all_free};
  std::vector<Gauge> gauges;
  Vec3d impulse, angular_impulse;
  std::size_t contacts = 0;

  void mount(const Gauge::Mounting& mounting) { gauges.emplace_back(mounting, *surface); }

  void run(int steps) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> mass(0.01, 0.05), away(0.2, 0.8);
    fixtures::TestPoints points;
    for (int i = 0; i < 3000; ++i) {
      points.x1.push_back(body.position_of_com() + away(random) * fixtures::random_direction(random));
      points.v.push_back({});
      points.m.push_back(mass(random));
    }
    std::erase_if(points.x1, [&](const Vec3d& x) { return fixtures::Soup(*surface).inside(body.pose().to_body(x)); });
    points.v.resize(points.x1.size()), points.m.resize(points.x1.size());
    Swept detector(surface, Unbounded{}, 0);
    const double radius = surface->radius_about(body.properties().centre_of_mass), dt = 1e-3;
    for (int step = 0; step < steps; ++step) {
      const Motion motion = body.advance(dt);
      points.x0 = points.x1;
      for (std::size_t i = 0; i < points.size(); ++i) points.x1[i] += dt * points.v[i];
      const ContactSum sum = respond(points, detect(detector, points, motion, body.travel_bound(motion, radius)), motion, body, 0.3,
                                     [&](const Contact& contact, const Vec3d& given) {
                                       for (Gauge& gauge : gauges) gauge.add(contact, points.position_t1(contact.point), given, motion);
                                     });
      impulse += sum.impulse, angular_impulse += sum.angular_impulse, contacts += sum.contacts;
    }
  }
};

}  // namespace

TEST_CASE("gauge: the gauges of all parts sum to the impulse on the body, with friction and rotation") {
  Shower shower;
  const Vec3d com = shower.body.properties().centre_of_mass;
  for (const char* part : {"bottom", "side", "top"}) shower.mount({.parts = {part}, .point = com});
  shower.run(60);
  CHECK(shower.contacts > 300);
  for (const Gauge& gauge : shower.gauges) CHECK(norm(gauge.reading().impulse) > 1e-3);
  // hundreds of impulses of about 0.1 N s, summed in another order
  CHECK(norm(sum_of(shower.gauges, &Gauge::Reading::impulse) - shower.impulse) < 1e-13 * static_cast<double>(shower.contacts));
  CHECK(norm(sum_of(shower.gauges, &Gauge::Reading::angular_impulse) - shower.angular_impulse) < 1e-13 * static_cast<double>(shower.contacts));
}

TEST_CASE("gauge: one without parts equals one with all parts, and reset clears it") {
  Shower shower;
  shower.mount({});
  shower.mount({.parts = {"top", "side", "bottom", "side"}});
  shower.run(20);
  CHECK(shower.gauges[0].reading().impulse == shower.gauges[1].reading().impulse);
  CHECK(shower.gauges[0].reading().impulse != Vec3d{});
  shower.gauges[0].reset();
  CHECK(shower.gauges[0].reading().impulse == Vec3d{});
}

TEST_CASE("gauge: a force through the axis has no torque about it, any other force times lever arm, about the rotated axis") {
  const Surface cylinder(fixtures::cylinder());
  const Vec3d point{0.3, -0.2, 0.1}, axis = normalised(Vec3d{1, 2, -1});
  const Pose start({1, 2, 3}, Quaternion::from_rotation({0.3, -1.1, 0.4}));
  RigidBody body({.mass = 1, .centre_of_mass = {}, .inertia = Mat3::identity()}, start, {3, 0, 1}, {2, 9, -4}, {});
  const Motion motion = body.advance(0.1);
  const auto torque = [&](const Vec3d& place, const Vec3d& direction) {  // place and direction in the body frame at the end of the step
    Gauge gauge({.parts = {}, .point = point, .axis = axis}, cylinder);
    gauge.add({.panel = 0}, motion.t1.to_world(place), motion.t1.turn_to_world(direction), motion);
    return gauge.reading().about_axis;
  };
  const Vec3d across = normalised(cross(axis, Vec3d{0, 0, 1})), up = cross(axis, across);
  const Vec3d on_axis = point + 0.7 * axis;
  CHECK(std::fabs(torque(on_axis, {5, -3, 8})) < 1e-14);                                // through the axis: rounding of 10 N s × 4 m
  CHECK(std::fabs(torque(on_axis + 0.4 * across, 6.0 * across + 2.0 * axis)) < 1e-14);  // in a plane with the axis
  CHECK(torque(on_axis + 0.4 * across, 6.0 * up) == fixtures::relative(0.4 * 6, 1e-14));
}

TEST_CASE("gauge: moments are about the reference point, which moves with the body") {
  const Surface cylinder(fixtures::cylinder());
  Gauge gauge({.parts = {}, .point = {0.5, 0, 0}}, cylinder);
  RigidBody body({.mass = 1, .centre_of_mass = {}, .inertia = Mat3::identity()}, Pose(), {0, 0, 20}, {0, 0, std::numbers::pi / 2}, {});
  const Motion motion = body.advance(1);  // a quarter turn and 20 m up: the point is at (0, 0.5, 20)
  gauge.add({.panel = 3}, {2, 0.5, 20}, {0, 0, 7}, motion);
  CHECK(norm(gauge.reading().angular_impulse - Vec3d{0, -14, 0}) < 1e-13);  // (2, 0, 0) × (0, 0, 7)
}

TEST_CASE("gauge: a contact without a panel counts for the whole surface only") {
  const Surface cylinder(fixtures::cylinder());
  Gauge whole({}, cylinder), side({.parts = {"side"}}, cylinder);
  for (Gauge* gauge : {&whole, &side}) gauge->add({.panel = -1}, {}, {1, 0, 0}, fixtures::at_rest());
  CHECK(whole.reading().impulse == Vec3d{1, 0, 0});
  CHECK(side.reading().impulse == Vec3d{});
}

TEST_CASE("gauge: the error for an unknown part lists the known ones") {
  const Surface cylinder(fixtures::cylinder()), box(fixtures::box());
  CHECK_THROWS_WITH_AS(Gauge({.parts = {"side", "botom"}}, cylinder),
                       "the surface has no part \"botom\"; did you mean bottom? Its parts are bottom, side, top.", InputError);
  CHECK_THROWS_WITH_AS(Gauge({.parts = {"hub"}}, cylinder), "the surface has no part \"hub\"; its parts are bottom, side, top.", InputError);
  CHECK_THROWS_WITH_AS(Gauge({.parts = {"hub"}}, box),
                       "the surface has no part \"hub\"; its panels have no names, so omit the parts, or name them in its file.", InputError);
}
