/// Boxes of ice in still water, and the balance of a run with them.
#pragma once

#include <algorithm>
#include <cmath>

#include "fixtures/larger.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/simulations.hpp"

namespace fixtures {

using namespace perimpact;

inline constexpr double ice = 900, sea = 1025, gravity = 9.81;  // [kg/m³], [m/s²]

inline FloatingSetup calm() { return {.level = 0, .density = sea, .gravity = gravity, .drag = 0}; }

struct BoxOptions {
  double youngs_modulus = 2e6, density = ice, spacing = 0.5;
};

/// A box of soft ice, so that few steps make a second, with its middle at z.
inline Setup floating_box(const Vec3d& size, double z, const FloatingSetup& water, double end, const BoxOptions& options = {}) {
  Setup setup;
  setup.time = {.end = end};
  BodySetup body = body_setup({.size = size, .spacing = options.spacing});
  body.name = "ice";
  body.position = {0, 0, z};
  body.material = OrdinaryStateSetup{ElasticSetup{.youngs_modulus = options.youngs_modulus, .poissons_ratio = 0.25, .density = options.density}};
  body.boundary_conditions = {{"sea", water}};
  setup.bodies = {body};
  setup.output.history_interval = 0.01;
  return setup;
}

/// [m] z of the middle of the only body.
inline double middle(const Simulation& simulation) {
  const Particles& particles = simulation.bodies()[0].particles;
  double sum = 0;
  for (const std::uint32_t slot : particles.slot_of()) sum += particles.position.at(slot).z;
  return sum / static_cast<double>(particles.size());
}

/// What water did to a box up to the end of its run, from the rows of the history.
struct WaterBalance {
  double impulse = 0;       // [N s] upward
  double largest_work = 0;  // [J]
  double largest_gap = 0;   // [J] between the change of energy and the work
};

inline WaterBalance run_in_water(Simulation& simulation) {
  WaterBalance sum;
  const double before = value(simulation, "total.energy [J]");
  while (!simulation.clock().is_finished()) {
    const double row = value(simulation, "time [s]");
    simulation.step();
    if (!simulation.monitors().is_due(simulation.clock())) continue;
    sum.impulse += value(simulation, "ice.sea.force_z [N]") * (value(simulation, "time [s]") - row);
    const double work = value(simulation, "ice.sea.work [J]");
    sum.largest_work = fixtures::larger(sum.largest_work, std::fabs(work));
    sum.largest_gap = fixtures::larger(sum.largest_gap, std::fabs(value(simulation, "total.energy [J]") - before - work));
  }
  return sum;
}

}  // namespace fixtures
