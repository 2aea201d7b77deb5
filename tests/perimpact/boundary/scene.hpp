/// A body with boundaries, stepped by hand: no impactors, no monitors.
#pragma once

#include <functional>
#include <map>
#include <utility>

#include "perimpact/bodies.hpp"
#include "perimpact/boundary/boundaries.hpp"
#include "perimpact/particles/advance.hpp"
#include "perimpact/simulation/clock.hpp"

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
  Boundaries boundaries;
  Clock clock;
  std::vector<double> travel;
  double elastic_energy = 0;  ///< [J]

  BoundedBody(const BodySetup& setup, const Regions& regions, double dt)
      : body(make_body(setup)),
        boundaries(setup, elastic_of(setup), body.particles, slots_of(body.particles, regions)),
        clock{dt, 0},
        travel(travel_blocks(body.particles)) {
    boundaries.place(body.particles, 0, Held::Pace::moving);
    evaluate();
  }

  void step() {
    ++clock.step;
    advance(body.particles, clock.dt, travel);
    boundaries.lead(body.particles, clock.latest(), travel);
    evaluate();
  }

  void evaluate() {
    elastic_energy = body.internal.evaluate_with_energy(body.particles, body.family);
    boundaries.add_forces(body.particles, clock.next());
  }

  double energy() const { return elastic_energy + body.kinetic_energy(clock.dt); }  ///< [J]
};

}  // namespace fixtures
