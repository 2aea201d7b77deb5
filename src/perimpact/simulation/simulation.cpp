#include "perimpact/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "fccda/respond/together.hpp"
#include "perimpact/setup/setup_error.hpp"
#include "perimpact/simulation/stable_step.hpp"
#include "perimpact/simulation/state_hash.hpp"

namespace perimpact {

namespace {

std::vector<Body> make_bodies(const Setup& setup) {
  std::vector<Body> bodies;
  for (const BodySetup& body : setup.bodies) bodies.push_back(make_body(body));
  return bodies;
}

constexpr double safety = 0.9;  // of the estimate, which errs on the safe side by a factor near two

Stability find_step(const Setup& setup, std::span<const Body> bodies, std::vector<std::string>& warnings) {
  Stability stability{0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const Body& body : bodies) {
    stability.estimate = std::min(stability.estimate, silling_askari_step(body));
    stability.exact = std::min(stability.exact, exact_stable_step(body));
  }
  const double automatic = safety * stability.estimate;
  if (!setup.time.step && !std::isfinite(automatic))
    throw SetupError("time", "no body has a bond, so nothing tells how long a stable time step is; give time.step, or take smaller spacings.");
  stability.step = setup.time.step.value_or(setup.time.end / std::ceil(setup.time.end / automatic));
  if (stability.step > setup.time.end)
    throw SetupError("time.step", fmt::format("a time step of {:.4g} s is longer than the whole run of {:.4g} s; make it shorter, or leave it out.",
                                              stability.step, setup.time.end));
  if (stability.step >= stability.exact)
    throw SetupError("time.step", fmt::format("a time step of {:.4g} s is {:.3g} times the longest stable one of this lattice ({:.4g} s): the run would blow "
                                              "up. Take at most {:.4g} s, or leave the step out.",
                                              stability.step, stability.step / stability.exact, stability.exact, automatic));
  constexpr double most_steps = 1e15;  // are counted without rounding, and would take thirty years at a million a second
  if (!(setup.time.end / stability.step <= most_steps))
    throw SetupError("time.end", fmt::format("the run would take {:.3g} steps of {:.3g} s; end it earlier, or make the step longer.",
                                             setup.time.end / stability.step, stability.step));
  if (stability.step > automatic * (1 + 1e-9))
    warnings.push_back(
        fmt::format("The time step of {:.4g} s is {:.3g} times the safe estimate ({:.4g} s) and {:.3g} times the exact limit of the lattice; near surfaces it "
                    "may be unstable.",
                    stability.step, stability.step / automatic, automatic, stability.step / stability.exact));
  return stability;
}

/// A bond reaches three particles: thinner bodies are all surface, and no correction makes up for that.
void warn_of_thin_bodies(std::span<const Body> bodies, std::vector<std::string>& warnings) {
  constexpr int enough = 4;
  for (const Body& body : bodies) {
    const auto& cells = body.particles.lattice().cells;
    const int thinnest = *std::min_element(cells.begin(), cells.end());
    if (thinnest < enough)
      warnings.push_back(
          fmt::format("Body {} is only {} particles thick: its stiffness is far off, above all in bending. Take a spacing that gives at least {}, better 6.",
                      body.name, thinnest, enough));
  }
}

std::vector<Impactor> make_impactors(const Setup& setup, std::span<Body> bodies) {
  std::vector<Particles*> particles;
  for (Body& body : bodies) particles.push_back(&body.particles);
  std::vector<Impactor> impactors;
  for (const ImpactorSetup& impactor : setup.impactors) impactors.emplace_back(impactor, setup.contact.impactors, particles);
  return impactors;
}

/// An impactor against one of the bodies, as strike_together sees it.
struct ImpactorOnBody {
  Impactor& impactor;
  std::size_t body;

  std::span<const fccda::Contact> strike(StruckParticles& particles) { return impactor.strike(body, particles); }
  std::span<const fccda::Contact> strike_again(StruckParticles& particles, std::span<const std::size_t> which) {
    return impactor.strike_again(body, particles, which);
  }
  std::vector<std::size_t> still_inside(const StruckParticles& particles, std::span<const std::size_t> which) {
    return impactor.still_inside(body, particles, which);
  }
  void moved(std::size_t particle) { impactor.moved(body, particle); }
};

}  // namespace

Simulation::Simulation(const Setup& setup)
    : setup_(setup),
      bodies_(make_bodies(setup)),
      stability_(find_step(setup, bodies_, warnings_)),
      clock_{stability_.step, std::max(1L, static_cast<long>(std::ceil(setup.time.end / stability_.step - 1e-6)))},
      impactors_(make_impactors(setup, bodies_)),
      monitors_(setup.output, bodies_, clock_) {
  warn_of_thin_bodies(bodies_, warnings_);
  for (const Body& body : bodies_) travel_.emplace_back(travel_blocks(body.particles.lattice()), 0.0);
  expect_outside();
  evaluate_forces();
  monitors_.record(bodies_, impactors_, clock_);
}

void Simulation::expect_outside() {
  for (Impactor& impactor : impactors_)
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const StruckParticles particles(bodies_[b].particles, travel_[b], clock_.dt);
      if (const std::size_t inside = impactor.particles_inside(b, particles))
        throw SetupError("impactors." + impactor.name() + ".position",
                         fmt::format("impactor {} starts inside body {}: {} particles are inside its surface, or nearer to it than the contact radius. Move it "
                                     "away, or check the units of its surface.",
                                     impactor.name(), bodies_[b].name, inside));
    }
}

void Simulation::step() {
  ++clock_.step;
  timers_.timed("predict", [&] { advance_bodies(); });
  timers_.timed("contact", [&] { strike(); });
  timers_.timed("forces", [&] { evaluate_forces(); });
  timers_.timed("monitors", [&] {
    if (monitors_.is_due(clock_)) monitors_.record(bodies_, impactors_, clock_);
  });
}

void Simulation::advance_bodies() {
  for (std::size_t b = 0; b < bodies_.size(); ++b) advance(bodies_[b].particles, clock_.dt, travel_[b]);
}

void Simulation::strike() {
  for (Impactor& impactor : impactors_) impactor.advance(clock_.dt);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    StruckParticles particles(bodies_[b].particles, travel_[b], clock_.dt);
    std::vector<ImpactorOnBody> strikers;
    for (Impactor& impactor : impactors_) strikers.push_back({impactor, b});
    const auto pinched = fccda::strike_together(std::span(strikers), particles);
    for (std::size_t i = 0; i < impactors_.size(); ++i) impactors_[i].note_pinched(b, pinched[i].size(), clock_.time());
  }
}

std::vector<std::string> Simulation::closing_warnings() const {
  std::vector<std::string> warnings;
  for (const Impactor& impactor : impactors_)
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      if (const Pinched& pinched = impactor.pinched(b); pinched.count > 0)
        warnings.push_back(fmt::format(
            "Particles of body {} were pinched between impactor {} and others, first at t = {:.4g} s: summed over steps, {} were left inside it, since no "
            "place "
            "outside of all was found. Forces on the impactors are not to be trusted where they close in on a body by more than it can give way; check their "
            "courses, or leave them apart by two spacings at least.",
            bodies_[b].name, impactor.name(), pinched.first, pinched.count));
  return warnings;
}

void Simulation::evaluate_forces() {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
    if (monitors_.is_due(clock_))
      monitors_.elastic_energy()[b] = body.internal.evaluate_with_energy(body.particles, body.family);
    else
      body.internal.evaluate(body.particles, body.family);
  }
}

std::size_t Simulation::contacts() const {
  std::size_t sum = 0;
  for (const Impactor& impactor : impactors_) sum += impactor.account().contacts;
  return sum;
}

std::uint64_t Simulation::state_hash() {
  StateHash hash;
  visit_state(hash);
  return hash.value();
}

}  // namespace perimpact
