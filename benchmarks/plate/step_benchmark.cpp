/// Steps per second of Simulation::step() on a deck, and the time by phase: one CSV row on standard output.
///
///   step_benchmark cases/plate_impact/deck.yaml --set bodies.plate.family=madenci-oterkus --threads 1 --steps 100
///
/// Nothing is written during the run, so only the solver is timed: prediction, contact, bond loop, monitors.

#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "io/deck/deck.hpp"
#include "perimpact/simulation/simulation.hpp"
#include "root_and_division.hpp"

namespace {

using namespace perimpact;

struct Arguments {
  std::string deck;
  std::vector<std::string> set;
  int threads = 1;
  int warm_up = 100;  // for the plate: 10 µs, with contact established and the wave well inside
  int steps = 100;    // for the plate: ten rows of history
};

Arguments parse(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Times Simulation::step() on a deck; prints one CSV row.");
  app.add_option("deck", arguments.deck, "the deck")->required()->check(CLI::ExistingFile);
  app.add_option("--set", arguments.set, "key.path=value: changes the deck")->allow_extra_args(false);
  app.add_option("--threads", arguments.threads, "number of threads")->check(CLI::PositiveNumber);
  app.add_option("--warm-up", arguments.warm_up, "untimed steps at the start")->check(CLI::NonNegativeNumber);
  app.add_option("--steps", arguments.steps, "timed steps; a multiple of the history interval, or the share of monitors is wrong")->check(CLI::PositiveNumber);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  return arguments;
}

/// CPU time of all threads of this process [s].
double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double wall_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::string compiler() {
#ifdef __clang__
  return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

struct Measurement {
  double wall = 0, cpu = 0;  // [s]
  double contacts = 0;       // per step
  fccda::Timers before, after;
};

Measurement measure(Simulation& simulation, const Arguments& arguments) {
  for (int step = 0; step < arguments.warm_up; ++step) simulation.step();
  Measurement measurement{.before = simulation.timers()};
  const double wall = wall_seconds(), cpu = cpu_seconds();
  for (int step = 0; step < arguments.steps; ++step) {
    simulation.step();
    measurement.contacts += static_cast<double>(simulation.contacts()) / arguments.steps;
  }
  measurement.wall = wall_seconds() - wall;
  measurement.cpu = cpu_seconds() - cpu;
  measurement.after = simulation.timers();
  return measurement;
}

void print_row(const Arguments& arguments, const Simulation& simulation, const Measurement& measured, double rate) {
  const Body& body = simulation.bodies().front();
  const BodySetup& setup = simulation.setup().bodies.front();
  const double directed_bonds = 2.0 * static_cast<double>(body.family.intact_bonds());
  const double steps_per_second = arguments.steps / measured.wall;
  const auto share = [&](std::string_view timer) { return (measured.after.seconds(timer) - measured.before.seconds(timer)) / measured.wall; };

  fmt::print(
      "particles,family,nu,correction,threads,isa,steps,steps/s,directed_bonds/step,directed_bonds/s,root_and_division/s,share_of_core,"
      "predict,contact,forces,monitors,contacts/step,broken_bonds,cpu_use,compiler\n");
  fmt::print("{},{},{},{},{},{},{},{:.4g},{:.0f},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.1f},{},{:.3f},{}\n", body.particles.size(),
             body.family.stencil()->size(), setup.elastic().poissons_ratio, setup.surface_correction.word(), arguments.threads, benchmark::instruction_set,
             arguments.steps, steps_per_second, directed_bonds, directed_bonds * steps_per_second, rate,
             directed_bonds * steps_per_second / (rate * arguments.threads), share("predict"), share("contact"), share("forces"), share("monitors"),
             measured.contacts, body.internal.broken_bonds(), measured.cpu / (measured.wall * arguments.threads), compiler());
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments = parse(argc, argv);
  try {
    fccda::use_threads(arguments.threads);
    const deck::Deck deck = deck::read_deck(arguments.deck, arguments.set);
    Simulation simulation(deck.setup);
    const double rate_before = benchmark::root_and_division_rate();
    const Measurement measured = measure(simulation, arguments);
    print_row(arguments, simulation, measured, std::max(rate_before, benchmark::root_and_division_rate()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}
