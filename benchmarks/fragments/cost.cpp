/// Cost of contact between fragments relative to the bonds, by the fragmented share of a body: CSV rows on standard output.
///
///   fragments_cost --threads 1
///
/// A plate of 100 × 60 × 12 particles; in 0, 5, 25 and 100 % of it, from one end, all bonds are broken and the particles move randomly at a
/// hundredth of the speed of sound and collide. The steps are those of Simulation::step(), and the times those of its timers.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "base/parallel.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace {

using namespace perimpact;

struct Arguments {
  int threads = 1;
  int warm_up = 20, steps = 100, rounds = 3;
};

constexpr double youngs_modulus = 9e9, density = 900, spacing = 0.01;

Setup plate(bool touches) {
  Setup setup;
  setup.time.end = 1;
  BodySetup body;
  body.name = "plate";
  body.shape = BoxSolid{{100 * spacing, 60 * spacing, 12 * spacing}};
  body.spacing = spacing;
  OrdinaryStateSetup material;
  material.youngs_modulus = youngs_modulus, material.density = density;
  material.critical_stretch = 0.5;
  body.material = material;
  setup.bodies = {body};
  setup.contact.fragments.law.index = static_cast<int>(touches ? FragmentLaw::repulsive : FragmentLaw::none);
  setup.contact.fragments.friction = 0.1;
  setup.output.history_interval = 0.5;
  return setup;
}

/// Calls f(values) with the named array of the state.
template <class T, class F>
void with_state(Simulation& simulation, const std::string& wanted, const F& f) {
  bool is_found = false;
  simulation.visit_state([&](const std::string& name, auto&& values) {
    if constexpr (std::is_convertible_v<decltype(values), std::span<T>>)
      if (name == wanted) f(std::span<T>(values)), is_found = true;
  });
  if (!is_found) throw std::logic_error("the state has no array " + wanted + " of these numbers");
}

/// Breaks all bonds in that share of the plate, from low x, and sets random velocities.
void loosen(Simulation& simulation, double share) {
  const Body& body = simulation.bodies().front();
  const Particles& particles = body.particles;
  std::vector<std::uint8_t> loose(particles.slots(), 0);
  for (const std::uint32_t slot : particles.slot_of()) loose[slot] = particles.reference(slot).x < (share - 0.5) * 100 * spacing;
  with_state<std::uint8_t>(simulation, "plate.bonds", [&](std::span<std::uint8_t> bits) {
    for (const std::uint32_t slot : particles.slot_of()) {
      const std::size_t eight = slot / fccda::byte_lanes, first = body.family.begin(eight);
      body.family.for_each_bond(slot, [&](const FamilyBond& bond) {
        if (loose[slot] || loose[bond.j]) bits[first + bond.index] = static_cast<std::uint8_t>(bits[first + bond.index] & ~(1u << slot % fccda::byte_lanes));
      });
    }
  });
  with_state<std::uint32_t>(simulation, "plate.broken_ends_of_eight", [&](std::span<std::uint32_t> ends) {
    for (std::uint32_t& count : ends) count += share > 0;
  });
  std::mt19937_64 random(1);
  std::normal_distribution<double> speed(0, 0.01 * std::sqrt(youngs_modulus / density));
  for (const char* axis : {"x", "y", "z"})
    with_state<double>(simulation, std::string("plate.velocity_") + axis, [&](std::span<double> velocity) {
      for (const std::uint32_t slot : particles.slot_of())
        if (loose[slot]) velocity[slot] = speed(random);
    });
}

struct Times {
  double forces, fragments;  // [s] per step
  double lists, contacts;    // per step
};

Times measured_once(double share, bool touches, const Arguments& arguments) {
  Simulation simulation(plate(touches));
  loosen(simulation, share);
  for (int step = 0; step < arguments.warm_up; ++step) simulation.step();
  const fccda::Timers before = simulation.timers();
  const auto made = [&] { return touches ? static_cast<double>(simulation.fragments()->near_pairs().times_made()) : 0; };
  const double first = made();
  double contacts = 0;
  for (int step = 0; step < arguments.steps; ++step) {
    simulation.step();
    if (touches) contacts += static_cast<double>(simulation.fragments()->contacts());
  }
  const fccda::Timers& after = simulation.timers();
  const auto of_step = [&](std::string_view name) { return (after.seconds(name) - before.seconds(name)) / arguments.steps; };
  return {of_step("forces"), of_step("fragments"), (made() - first) / arguments.steps, contacts / arguments.steps};
}

/// The minimum of the rounds, since other load on the machine only adds time.
Times measure(double share, bool touches, const Arguments& arguments) {
  Times least = measured_once(share, touches, arguments);
  for (int round = 1; round < arguments.rounds; ++round) {
    const Times again = measured_once(share, touches, arguments);
    least.forces = std::min(least.forces, again.forces);
    least.fragments = std::min(least.fragments, again.fragments);
  }
  return least;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Times contact between fragments relative to the bonds; prints CSV.");
  app.add_option("--threads", arguments.threads, "number of threads")->check(CLI::PositiveNumber);
  app.add_option("--warm-up", arguments.warm_up, "untimed steps at the start")->check(CLI::NonNegativeNumber);
  app.add_option("--steps", arguments.steps, "timed steps")->check(CLI::PositiveNumber);
  app.add_option("--rounds", arguments.rounds, "number of rounds, of which the minimum counts")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  fccda::use_threads(arguments.threads);
  const double whole = measure(0, false, arguments).forces;
  fmt::print("loose,threads,steps,bonds [ms/step],fragments [ms/step],fragments/bonds of the whole plate,lists/step,contacts pairs\n");
  for (const double share : {0.0, 0.05, 0.25, 1.0}) {
    const Times times = measure(share, true, arguments);
    fmt::print("{},{},{},{:.4g},{:.4g},{:.3g},{:.3g},{:.0f}\n", share, arguments.threads, arguments.steps, 1e3 * times.forces, 1e3 * times.fragments,
               times.fragments / whole, times.lists, times.contacts);
  }
  return 0;
}
