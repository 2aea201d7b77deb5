/// A swarm of points attracted by a free body, so that they hit it, slide on it and push it continually. The attraction is along
/// the line to the centre of mass and acts on both alike: it changes neither linear nor angular momentum.
#pragma once

#include "fccda/evidence/shapes.hpp"
#include "fccda/respond/respond.hpp"

namespace evidence {

struct SwarmSetup {
  std::size_t count = 200;
  double radius = 0.01;  ///< contact radius [m]
  double friction = 0;
  double dt = 2e-3;  ///< [s]
  Vec3d centre_of_mass{0.02, -0.01, 0.01};
};

class Swarm {
 public:
  Swarm(const std::shared_ptr<const Surface>& surface, const SwarmSetup& setup)
      : detector(surface, Unbounded{}, setup.radius),
        body({.mass = 300, .centre_of_mass = setup.centre_of_mass, .inertia = Mat3::diagonal({10, 20, 25})}, Pose(), {0.3, 0.1, 0}, {0.2, -0.3, 0.5},
             {{true, true, true, true, true, true}}),
        setup_(setup),
        reach_(surface->radius_about(body.properties().centre_of_mass)) {
    std::mt19937_64 random(71);
    std::uniform_real_distribution<double> distance(0.7, 1), mass(0.5, 1.5);
    for (std::size_t i = 0; i < setup.count; ++i) {
      points.x1.push_back(distance(random) * fixtures::random_direction(random));
      points.v.push_back(0.3 * fixtures::random_direction(random));
      points.m.push_back(mass(random));
    }
    points.block = 16;
    points.x0 = points.x1;
  }

  /// Calls `report(contact, impulse on the body)` for the contacts of the step.
  template <class Report>
  ContactSum step(const Report& report) {
    Vec3d drawn{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3d change = setup_.dt * pull * normalised(body.position_of_com() - points.x1[i]);
      points.v[i] += change;
      drawn -= points.m[i] * change;
    }
    body.add_impulse(drawn, {});
    motion = body.advance(setup_.dt);
    points.x0 = points.x1;
    for (std::size_t i = 0; i < points.size(); ++i) points.x1[i] += setup_.dt * points.v[i];
    return respond(points, fixtures::detect(detector, points, motion, body.travel_bound(motion, reach_)), motion, body, setup_.friction, report);
  }
  ContactSum step() {
    return step([](const Contact&, const Vec3d&) {});
  }

  Vec3d momentum() const {
    Vec3d sum = body.momentum();
    for (std::size_t i = 0; i < points.size(); ++i) sum += points.m[i] * points.v[i];
    return sum;
  }
  Vec3d angular_momentum() const {
    Vec3d sum = body.angular_momentum({});
    for (std::size_t i = 0; i < points.size(); ++i) sum += points.m[i] * cross(points.x1[i], points.v[i]);
    return sum;
  }

  fixtures::TestPoints points;
  Swept detector;
  RigidBody body;
  Motion motion;  ///< of the latest step

 private:
  static constexpr double pull = 3;  // [m/s²]

  SwarmSetup setup_;
  double reach_;
};

}  // namespace evidence
