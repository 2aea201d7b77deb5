/// A body with boundaries, stepped by hand: no impactors, no monitors.
#pragma once

#include <functional>
#include <map>
#include <utility>

#include "perimpact/bodies.hpp"
#include "perimpact/boundary_conditions/boundary_conditions.hpp"
#include "perimpact/integrate/clock.hpp"
#include "perimpact/particles/advance.hpp"

namespace fixtures {

using namespace perimpact;

/// Regions by what lies in them.
using Regions = std::map<std::string, std::function<bool(const Vec3d&)>>;

inline SlotsOfRegion slots_of(const Particles& particles, const Regions& regions) {
  return [&](const std::string& name, const std::string&) {
    std::vector<std::size_t> slots;
    for (const std::uint32_t slot : particles.slot_of())
      if (regions.at(name)(particles.reference(slot))) slots.push_back(slot);
    return slots;
  };
}

struct BoundedBody {
  Body body;
  BoundaryConditions boundary_conditions;
  Clock clock;
  std::vector<double> travel;
  double elastic_energy = 0;  ///< [J]

  BoundedBody(const BodySetup& setup, const Regions& regions, double dt)
      : body(make_body(setup)),
        boundary_conditions(setup, elastic_of(setup), body.particles, slots_of(body.particles, regions)),
        clock{dt, 0},
        travel(travel_blocks(body.particles)) {
    boundary_conditions.set_initial_state(body.particles, 0, PrescribedDisplacement::Regime::moving);
    evaluate();
  }

  void step() {
    ++clock.step;
    advance(body.particles, clock.dt, travel);
    boundary_conditions.impose_displacements(body.particles, clock.latest(), travel);
    evaluate();
  }

  void evaluate() {
    elastic_energy = body.internal.evaluate_with_energy(body.particles, body.family);
    boundary_conditions.add_forces(body.particles, clock.next());
  }

  double energy() const { return elastic_energy + body.motion(clock.dt).kinetic_energy; }  ///< [J]
};

}  // namespace fixtures
