/// Cost of each material: nanoseconds per directed bond of Simulation::step(), on a plate as a lattice and as an irregular point cloud. CSV on
/// standard output. Times are processor times of all threads, which other load on the machine affects little.
///
///   material_benchmark --cells 160 160 6 --threads 1 --steps 20

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace {

using namespace perimpact;
using fixtures::BodyOptions;
using fixtures::Model;

struct Arguments {
  std::vector<int> cells{160, 160, 6};
  int threads = 1, steps = 20, rounds = 5;
};

struct Case {
  std::string material;
  BodyOptions options;
};

std::vector<Case> cases() {
  return {{"ordinary-state, nu = 0.25", {.poissons_ratio = 0.25}},
          {"ordinary-state, nu = 0.3", {.poissons_ratio = 0.3}},
          {"linear-peridynamic-solid, nu = 0.3", {.poissons_ratio = 0.3, .model = Model::linear_solid}},
          {"correspondence, hencky", {.poissons_ratio = 0.3, .model = Model::correspondence, .stabilisation = Stabilisation::wan}},
          {"correspondence, hencky, bond-level", {.poissons_ratio = 0.3, .model = Model::correspondence}},
          {"correspondence, st-venant-kirchhoff",
           {.poissons_ratio = 0.3, .model = Model::correspondence, .law = StressLaw::st_venant_kirchhoff, .stabilisation = Stabilisation::wan}}};
}

void measure(const Arguments& arguments, const Case& which, Plane plane, bool as_lattice) {
  BodyOptions options = which.options;
  options.plane = plane;
  options.critical_stretch = 0.5;  // checked at every bond, never exceeded
  const auto length = [&](int axis) { return options.spacing * arguments.cells[static_cast<std::size_t>(axis)]; };
  options.size = {length(0), plane == Plane::none ? length(1) : length(1) * arguments.cells[2], plane == Plane::none ? length(2) : options.spacing};
  Setup setup;
  setup.bodies.push_back(fixtures::body_setup(options));
  setup.time.end = 1;
  setup.time.step = 1e-12;  // particles hardly move, so the timing does not depend on the motion
  Start start(setup);
  if (!as_lattice) start.particles[0] = fixtures::as_cloud(start.particles[0], 0.2);
  Simulation simulation(setup, std::move(start));
  double best = 1e300;
  for (int round = 0; round < arguments.rounds; ++round) {
    const std::clock_t before = std::clock();
    for (int step = 0; step < arguments.steps; ++step) simulation.step();
    best = std::min(best, static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / arguments.steps);
  }
  const Body& body = simulation.bodies().front();
  const double bonds = 2.0 * static_cast<double>(body.family.intact_bonds());
  fmt::print("\"{}\",{},{},{},{},{:.0f},{:.4g},{}\n", which.material, plane == Plane::none ? "space" : "plane", as_lattice ? "lattice" : "cloud",
             arguments.threads, body.particles.size(), bonds, 1e9 * best / bonds, body.internal.bytes() + body.family.bytes());
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Times Simulation::step() for each material on a lattice and on a point cloud; prints CSV.");
  app.add_option("--cells", arguments.cells, "cells of the plate in x, y and z; in two dimensions, y times z in y")->expected(3);
  app.add_option("--threads", arguments.threads, "number of threads")->check(CLI::PositiveNumber);
  app.add_option("--steps", arguments.steps, "steps per round")->check(CLI::PositiveNumber);
  app.add_option("--rounds", arguments.rounds, "number of rounds, of which the fastest counts")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  fccda::use_threads(arguments.threads);
  fmt::print("material,dimensions,points,threads,particles,directed_bonds,ns/directed_bond,bytes\n");
  for (const Plane plane : {Plane::none, Plane::stress})
    for (const bool as_lattice : {true, false})
      for (const Case& which : cases()) measure(arguments, which, plane, as_lattice);
}
