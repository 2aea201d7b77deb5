/// Points that meet a structure, advanced step by step with implicit coupling, without other forces on the points.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "fccda/deforming/scenes.hpp"
#include "fccda/elastic/structure_coupling.hpp"
#include "fixtures/larger.hpp"

namespace deforming {

/// A structure, its surface and points.
struct Impacts {
  Structure& structure;
  std::shared_ptr<DeformingSurface> surface;
  TestPoints points;
  double friction = 0;
  Deforming detector;
  StructureCoupling coupling;
  int most_passes = 0;
  Vec3d impulse{};  // [N s] on the structure, in the last step
  double work = 0;  // [J] on the structure so far

  Impacts(Structure& of, std::shared_ptr<DeformingSurface> its, double radius)
      : structure(of), surface(std::move(its)), detector(surface, radius), coupling(structure, *surface) {}

  void add(const Vec3d& place, const Vec3d& velocity, double mass) {
    points.x0.push_back(place), points.x1.push_back(place), points.v.push_back(velocity), points.m.push_back(mass);
  }

  void step(double dt) {
    points.x0 = points.x1;
    for (std::size_t i = 0; i < points.size(); ++i) points.x1[i] += dt * points.v[i];
    const TestPoints free = points;
    coupling.advance({0, dt, dt});
    std::vector<DeformingContact> contacts;
    for (int pass = 1;; ++pass) {
      contacts.clear();
      if (pass == 1)
        detector.detect(points, contacts);
      else
        detector.redetect(points, coupling.correction(), contacts);
      impulse = {};
      for (const DeformingContact& contact : contacts) {
        const std::size_t i = contact.contact.point;
        const PanelImpulse after = resolved(contact, points.position_t0(i), points.velocity(i), points.mass(i), dt, friction);
        points.set(i, after.point.position, after.point.velocity);
        coupling.add(contact, points.mass(i), after, friction);
        impulse += after.on_surface;
      }
      most_passes = fixtures::larger(most_passes, pass);
      if (pass == StructureCoupling::max_passes || coupling.agrees()) break;
      for (const DeformingContact& contact : contacts) {
        const std::size_t i = contact.contact.point;
        points.x1[i] = free.x1[i], points.v[i] = free.v[i];
        detector.moved(i);
      }
      pass + 1 == StructureCoupling::max_passes && !coupling.agrees(0.1) ? coupling.retreat() : coupling.correct();
    }
    work += coupling.finish();
  }

  Vec3d momentum() const {
    Vec3d sum{};
    for (std::size_t i = 0; i < points.size(); ++i) sum += points.m[i] * points.v[i];
    return sum;
  }
  Vec3d angular_momentum() const {
    Vec3d sum{};
    for (std::size_t i = 0; i < points.size(); ++i) sum += points.m[i] * cross(points.x1[i], points.v[i]);
    return sum;
  }
  double kinetic_energy() const {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) sum += 0.5 * points.m[i] * squared_norm(points.v[i]);
    return sum;
  }
};

}  // namespace deforming
