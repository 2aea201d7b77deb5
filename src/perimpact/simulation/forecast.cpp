#include "perimpact/simulation/forecast.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <string_view>

#include "perimpact/simulation/sample_block.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

namespace {

/// Blocks far from each other, without impactors and output.
Setup blocks_of(const Setup& setup, std::span<const Discretisation> bodies) {
  constexpr int cells = 64, cells_of_plane = 512, points = 40, points_of_plane = 256;  // larger than the caches; points have lists of bonds
  Setup blocks = setup;
  blocks.impactors = {};
  blocks.output.probes = {};
  blocks.output.lines = {};
  blocks.output.frames = 0;
  double place = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    BodySetup& body = blocks.bodies[b];
    const auto* cloud = std::get_if<Cloud>(&bodies[b]);
    const int along_axis = cloud ? (body.is_plane() ? points_of_plane : points) : body.is_plane() ? cells_of_plane : cells;
    const double size = along_axis * (cloud ? spacing_of(*cloud) : body.spacing.value());
    body = sample_block(body, bodies[b], along_axis);
    body.position.x = place + size;
    place += 3 * size;
  }
  return blocks;
}

/// Factor of the time of a stage of the set-up for so many times more particles. The surface correction and the bound of the step work on the particles
/// near surfaces, and once on all others.
double growth(std::string_view stage, std::span<const BodySetup> bodies, double more) {
  const bool is_of_surface = stage == "surface correction" || stage == "time step";
  const bool has_bonds =
      std::ranges::all_of(bodies, [](const BodySetup& body) { return with_material(body, [](const auto&, auto kind) { return kind.has_bonds; }); });
  return is_of_surface && has_bonds ? std::pow(more, bodies.front().is_plane() ? 1.0 / 2 : 2.0 / 3) : more;
}

}  // namespace

Forecast forecast_of(const Setup& setup, std::span<const Discretisation> bodies, double particles) {
  Simulation blocks(blocks_of(setup, bodies));
  double modelled = 0;
  for (const Body& body : blocks.bodies()) modelled += static_cast<double>(body.particles.size());
  Forecast forecast{.step = blocks.clock().dt, .steps = static_cast<double>(blocks.clock().steps), .set_up = 0, .running = 0};
  for (const auto& stage : blocks.set_up_timers().rows()) forecast.set_up += stage.seconds * growth(stage.name, setup.bodies, particles / modelled);
  if (blocks.clock().is_finished()) return forecast;
  blocks.step();  // warms caches
  constexpr int trial_steps = 5;
  const auto begin = std::chrono::steady_clock::now();
  long done = 0;
  for (; done < trial_steps && !blocks.clock().is_finished(); ++done) blocks.step();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (done > 0) forecast.running = seconds / static_cast<double>(done) * forecast.steps * particles / modelled;
  return forecast;
}

}  // namespace perimpact
