/// Scenes for runs of several ranks: bodies that break across the cuts between ranks.
#pragma once

#include <random>

#include "perimpact/bodies.hpp"

namespace fixtures {

using namespace perimpact;

/// A free cylinder that spins hits the edge of a plate and breaks bonds.
inline Setup struck_plate(const BodyOptions& options = {}) {
  Setup setup;
  setup.time = {.end = 12e-6, .step = 2e-7};
  BodyOptions its = options;
  its.size = {0.068, 0.042, options.plane == Plane::none ? 0.010 : 0.002}, its.spacing = 0.002;
  BodySetup plate = body_setup(its);
  plate.name = "plate";
  setup.bodies = {plate};
  ImpactorSetup cylinder;
  cylinder.name = "cylinder";
  cylinder.surface = CylinderSurface{.diameter = 0.03, .height = 0.03, .edge_length = 0.002};
  cylinder.mass = 0.02;
  cylinder.position = {0.003, 0.0361, 0};
  cylinder.velocity = {5, -200, 0};
  cylinder.angular_velocity = {0, 0, 800};
  cylinder.free_dofs = {"x", "y", "rz"};
  setup.impactors = {cylinder};
  setup.contact.impactors.friction = 0.2;
  return setup;
}

/// A block of finer particles, with a pole on the far side of a plate, shatters it; fragments slide, are damped and fly into the territory of other ranks.
inline Setup rubble(const BodyOptions& options = {}) {
  Setup setup;
  setup.time = {.end = 24e-6, .step = 2e-7};
  const bool plane = options.plane != Plane::none;
  const auto body = [&](const char* name, const Vec3d& size, const Vec3d& position, const Vec3d& velocity, double its_spacing) {
    BodyOptions its = options;
    its.size = {size.x, size.y, plane ? 0.002 : size.z}, its.spacing = its_spacing;
    BodySetup setup_of_body = body_setup(its);
    setup_of_body.name = name, setup_of_body.position = {position.x, position.y, plane ? 0 : position.z}, setup_of_body.velocity = velocity;
    return setup_of_body;
  };
  setup.bodies = {body("plate", {0.064, 0.016, 0.012}, {}, {}, 0.002), body("bullet", {0.012, 0.012, 0.006}, {0.003, 0.0145, 0.001}, {30, -500, 0}, 0.001),
                  body("pole", {0.016, 0.008, 0.012}, {0.004, -0.0122, 0}, {}, 0.002)};
  setup.contact.fragments.law.index = static_cast<int>(FragmentLaw::repulsive);
  setup.contact.fragments.friction = 0.2;
  return setup;
}

/// The same bodies as point clouds: points of their lattices moved by up to a fifth of the spacing, with volumes that differ by as much, in random order.
inline Setup scattered(Setup setup) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> move(-0.2, 0.2);
  for (BodySetup& body : setup.bodies) {
    const Particles lattice = make_particles(body);
    std::vector<std::uint32_t> slots(lattice.slot_of().begin(), lattice.slot_of().end());
    std::shuffle(slots.begin(), slots.end(), random);
    PointsShape points;
    points.file = body.name + ".csv", points.thickness = lattice.thickness();
    for (const std::uint32_t slot : slots) {
      const double h = lattice.spacing();
      points.points.push_back(lattice.reference(slot) - body.position + Vec3d{h * move(random), h * move(random), lattice.is_plane() ? 0 : h * move(random)});
      points.volumes.push_back(lattice.volume(slot) * (1 + move(random)));
    }
    body.shape = points, body.spacing.reset();
  }
  for (ImpactorSetup& impactor : setup.impactors) impactor.position.y += 0.0005;  // clear of the moved points
  return setup;
}

}  // namespace fixtures
