/// A whole simulation: built from a Setup, advanced step by step. It writes nothing; who wants results looks at it between steps
/// (run.hpp has the loop).
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/state.hpp"
#include "base/timers.hpp"
#include "perimpact/body/body.hpp"
#include "perimpact/boundary_conditions/boundary_conditions.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/diagnostics/proximity.hpp"
#include "perimpact/history/monitors.hpp"
#include "perimpact/impactor/impactor.hpp"
#include "perimpact/integrate/clock.hpp"
#include "perimpact/integrate/relax.hpp"
#include "perimpact/self_contact/short_range.hpp"
#include "perimpact/simulation/start.hpp"

namespace perimpact {

/// How the time step was found, over all bodies.
struct Stability {
  double step;      ///< [s] taken
  double estimate;  ///< [s] a bound, below the exact limit (safe_stable_step)
  /// [s] beyond which a body, with its surfaces, is unstable; found only where the step is above 0.9 of the estimate (exact_stable_step)
  std::optional<double> exact;
};

/// A force on the particles of a body that code of the caller's own computes.
struct UserForceOnBody {
  std::size_t body;
  std::string name;                                                                   ///< its columns of history.csv are <body>.<name>.force_x … and .work
  std::function<void(double time, const Body& body, VectorArray& density)> function;  ///< as OwnForce::Function, at the latest positions
};

class Simulation {
 public:
  /// Throws SetupError where the Setup cannot be simulated.
  explicit Simulation(const Setup& setup);
  /// The same from a start that has been made of the set-up, and perhaps been changed.
  Simulation(const Setup& setup, Start start, std::vector<UserForceOnBody> user_forces = {});

  /// One step in time or, where the set-up relaxes, one increment; the clock stays where it was where that is told to leave off, and the next
  /// call goes on. Throws RunError.
  void step(const KeepRelaxing& keep_on = {});

  const Setup& setup() const { return setup_; }
  const Clock& clock() const { return clock_; }
  const Stability& stability() const { return stability_; }
  const std::vector<std::string>& warnings() const { return warnings_; }                                  ///< known before the run
  std::vector<std::string> closing_warnings() const { return proximity_.warnings(bodies_, impactors_); }  ///< known at its end
  const fccda::Timers& timers() const { return timers_; }
  std::span<const InitialPenetration> initial_penetrations() const { return initial_penetrations_; }  ///< removed, or put on a surface
  std::span<const Body> bodies() const { return bodies_; }
  const std::optional<FilledMass>& filled_mass(std::size_t body) const { return filled_masses_[body]; }
  std::span<const BoundaryConditions> boundary_conditions() const { return boundary_conditions_; }  ///< of each body
  std::span<const Impactor> impactors() const { return impactors_; }
  const Monitors& monitors() const { return monitors_; }
  const std::optional<ShortRange>& fragments() const { return fragments_; }    ///< where the deck has them touch
  std::size_t contacts() const;                                                ///< of the last step
  const std::optional<Relaxation>& relaxation() const { return relaxation_; }  ///< in place of dynamics
  /// Has the pairs of particles that may touch looked for anew; changes no result.
  void forget_near_pairs() {
    if (fragments_) fragments_->forget();
  }

  /// What the next step depends on, as base/state.hpp says. A simulation of the same Setup that is given another's state and record
  /// goes on as the other would have.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit("step", clock_.step);
    for (Body& body : bodies_) body.visit_state(visit);
    for (Impactor& impactor : impactors_) impactor.visit_state(visit);
    if (fragments_) fragments_->visit_state(fccda::under("fragments", visit));
    if (relaxation_) relaxation_->visit_state(fccda::under("relaxation", visit));
  }
  std::uint64_t state_hash();

  /// Likewise what was noted of the run so far: no step depends on it, but history, warnings and run.json do.
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    for (Body& body : bodies_) body.visit_record(visit);
    for (BoundaryConditions& boundary_conditions : boundary_conditions_) boundary_conditions.visit_record(visit);
    for (Impactor& impactor : impactors_) impactor.visit_record(visit);
    if (fragments_) fragments_->visit_record(fccda::under("fragments", visit));
    monitors_.visit_state(fccda::under("monitors", visit));
    proximity_.visit_state(fccda::under("encounters", visit));
  }

 private:
  void advance_bodies();
  void resolve_impactor_contact();
  std::vector<std::size_t> resolve_body(std::size_t body, ContactParticles& particles);  // how many each impactor has pinched
  void compute_bond_forces();
  void add_short_range_forces();
  void apply_boundary_conditions();
  void relax(const KeepRelaxing& keep_on);
  void end_load_interval();
  void sample_monitors();

  Setup setup_;
  std::vector<std::string> warnings_;
  std::vector<InitialPenetration> initial_penetrations_;
  std::vector<std::optional<FilledMass>> filled_masses_;
  std::vector<Body> bodies_;
  std::vector<BoundaryConditions> boundary_conditions_;  // of each body
  std::optional<ShortRange> fragments_;
  Stability stability_;
  Clock clock_;  // counts increments where bodies are relaxed
  std::optional<Relaxation> relaxation_;
  std::vector<Impactor> impactors_;
  long load_steps_;                          // over which loads of panels are averaged
  std::vector<std::vector<double>> travel_;  // [m] of each body's blocks in this step
  Monitors monitors_;
  ProximityMonitor proximity_;
  fccda::Timers timers_;
};

}  // namespace perimpact
