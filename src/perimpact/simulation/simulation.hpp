/// Simulation, built from a Setup and advanced step by step. It writes no output; writers read its state between steps.
#pragma once

#include <cstddef>
#include <cstdint>
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
#include "perimpact/device/body_on_device.hpp"
#include "perimpact/device/boundary_conditions_on_device.hpp"
#include "perimpact/device/processor.hpp"
#include "perimpact/device/short_range_on_device.hpp"
#include "perimpact/diagnostics/proximity.hpp"
#include "perimpact/history/monitors.hpp"
#include "perimpact/impactor/impactor.hpp"
#include "perimpact/integrate/clock.hpp"
#include "perimpact/integrate/relax.hpp"
#include "perimpact/moving_window/moving_window.hpp"
#include "perimpact/self_contact/short_range.hpp"
#include "perimpact/simulation/shared_state.hpp"
#include "perimpact/simulation/short_range_of.hpp"
#include "perimpact/simulation/start.hpp"
#include "perimpact/simulation/time_step.hpp"

namespace perimpact {

/// User force on the particles of a body.
struct UserForceOnBody {
  std::size_t body;
  std::string name;                                                                   ///< its columns of history.csv are `<body>.<name>.force_x` … and .work
  std::function<void(double time, const Body& body, VectorArray& density)> function;  ///< see UserForce::Function, at the latest positions
};

class Simulation {
 public:
  /// Throws SetupError if the Setup is invalid.
  /// `loads`: of each body in an earlier run, by which ranks divide them, or none.
  explicit Simulation(const Setup& setup, fccda::Stages::Announce announce = {}, Ranks& ranks = alone(), std::span<const MeasuredLoad> loads = {},
                      const Processor& processor = {});
  /// The same from a Start of this Setup, possibly modified.
  Simulation(const Setup& setup, Start start, std::vector<UserForceOnBody> user_forces = {}, const Processor& processor = {});

  /// Advances by one time step or, with time.relax, by one increment. If keep_on interrupts an increment, the clock is unchanged and the next
  /// call resumes it. Throws RunError.
  void step(const KeepRelaxing& keep_on = {});

  Ranks& ranks() const { return *ranks_; }  ///< which share the bodies
  std::string device_name() const;          ///< of the device that computes the forces of bodies; empty without
  const Setup& setup() const { return setup_; }
  const Clock& clock() const { return clock_; }
  const Stability& stability() const { return stability_; }
  const std::vector<std::string>& warnings() const { return warnings_; }                              ///< before the run
  std::vector<std::string> closing_warnings() const;                                                  ///< at the end of the run
  const fccda::Timers& timers() const { return timers_; }                                             ///< of the phases of a step
  const Traffic& traffic_of_steps() const { return traffic_of_steps_; }                               ///< of this rank in step(), where it is counted
  double seconds_of_forces() const;                                                                   ///< [s] in the phases of force, without waiting for ranks
  const fccda::Timers& set_up_timers() const { return stages_.timers(); }                             ///< of the stages of the set-up
  std::span<const InitialPenetration> initial_penetrations() const { return initial_penetrations_; }  ///< removed, or projected onto a surface
  std::span<const Body> bodies() const {                                                              ///< valid until the next step
    bring_to_host();
    return bodies_;
  }
  const std::optional<FilledMass>& filled_mass(std::size_t body) const { return filled_masses_[body]; }
  std::span<const BoundaryConditions> boundary_conditions() const { return boundary_conditions_; }  ///< of each body
  std::span<const Impactor> impactors() const { return impactors_; }
  std::span<const MovingWindow> moving_windows() const { return windows_; }
  const Monitors& monitors() const { return monitors_; }
  const std::optional<ShortRange>& fragments() const { return fragments_; }    ///< if contact of fragments is enabled
  std::size_t contacts() const;                                                ///< of the last step
  const std::optional<Relaxation>& relaxation() const { return relaxation_; }  ///< in place of dynamics
  /// Discards the neighbour list of the short-range force; does not change results.
  void forget_near_pairs() {
    if (fragments_on_device_) fragments_on_device_->to_host(*fragments_);
    if (fragments_) fragments_->forget();
  }

  /// State on which the next step depends (base/state.hpp). A simulation of the same Setup with this state and record continues bitwise
  /// identically.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    bring_to_host();
    visit("step", clock_.step);
    for (MovingWindow& window : windows_) {
      const std::array<int, 3> first = window.first();
      window.visit_state(visit);
      if (window.first() == first) continue;
      release_from_device();
      rebuild(window);  // a restart: what follows belongs to the body there
    }
    visit_parts(visit);
    if (on_device_.empty()) return copy_to_device();
    for (OnDevice& one : on_device_) one.body.renew(), one.boundary_conditions.renew();  // the visitor may write
  }
  std::uint64_t state_hash();  ///< of the whole state; the same for any number of ranks and threads. Collective.

  /// The arrays of the whole run, as one rank has them, passed to the sink on the root. Collective.
  template <class Sink>
  void visit_whole_state(Sink sink) {
    visit_state(GatheredState(bodies(), *ranks_, std::move(sink)));
  }
  template <class Sink>
  void visit_whole_record(Sink sink) {
    visit_record(GatheredState(bodies(), *ranks_, std::move(sink)));
  }
  /// Takes the state of this rank from a source of these arrays. Collective.
  template <class Source>
  void take_whole_state(Source source) {
    visit_state(TakenState(bodies(), *ranks_, std::move(source)));
  }
  template <class Source>
  void take_whole_record(Source source) {
    visit_record(TakenState(bodies(), *ranks_, std::move(source)));
  }

  /// Record of the run, which affects history, warnings and run.json, but not the steps.
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    for (OnDevice& one : on_device_) one.boundary_conditions.record_to_host();
    for (Body& body : bodies_) body.visit_record(visit);
    for (BoundaryConditions& boundary_conditions : boundary_conditions_) boundary_conditions.visit_record(visit);
    for (OnDevice& one : on_device_) one.boundary_conditions.renew();
    for (Impactor& impactor : impactors_) impactor.visit_record(visit);
    if (fragments_) fragments_->visit_record(fccda::under("fragments", visit));
    for (MovingWindow& window : windows_) window.visit_record(visit);
    monitors_.visit_state(fccda::under("monitors", visit));
    proximity_.visit_state(fccda::under("encounters", visit));
  }

 private:
  template <class Visitor>
  void visit_parts(Visitor&& visit) {
    for (Body& body : bodies_) body.visit_state(visit);
    for (BoundaryConditions& boundary_conditions : boundary_conditions_) boundary_conditions.visit_state(visit);
    for (Impactor& impactor : impactors_) impactor.visit_state(visit);
    if (fragments_on_device_) fragments_on_device_->to_host(*fragments_);
    if (fragments_) fragments_->visit_state(contacting_bodies(setup_, bodies_), fccda::under("fragments", visit));
    if (relaxation_) relaxation_->visit_state(fccda::under("relaxation", visit));
  }
  struct OnDevice {
    BodyOnDevice body;
    BoundaryConditionsOnDevice boundary_conditions;
  };
  /// Null without a device.
  OnDevice* on_device(std::size_t body) { return on_device_.empty() ? nullptr : &on_device_[body]; }
  /// Must be called before the host reads particles of any slots. Without a device they are there.
  void bring_to_host() const {
    for (const OnDevice& one : on_device_) one.body.to_host();
  }
  /// Makes the copies of the bodies on the device, if there is one.
  void copy_to_device();
  /// Brings the bodies to the host, whose arrays may then change their addresses and sizes.
  void release_from_device();
  void move_windows();
  void move_window(MovingWindow& window, long moves);
  void rebuild(const MovingWindow& window);
  void use_scalar_kernels();
  void perform_step(const KeepRelaxing& keep_on);
  void time_forces(std::string_view phase, const std::function<void()>& compute);
  void advance_bodies();
  void resolve_impactor_contact();
  void isolate_crushed();
  void isolate(std::size_t body, std::span<const std::size_t> whole_slots);
  std::vector<std::size_t> resolve_body(std::size_t body, ContactParticles& particles);  // number of unresolved penetrations per impactor
  void begin_refresh_ghosts();
  void compute_bond_forces();
  void add_short_range_forces();
  void apply_boundary_conditions();
  void relax(const KeepRelaxing& keep_on);
  void end_load_interval();
  void sample_monitors();
  std::vector<MotionSums> motion_of_bodies();  // brings to the host what monitors read of particles

  Ranks* ranks_;
  Setup setup_;
  fccda::Stages stages_;
  std::vector<std::string> warnings_;
  std::vector<InitialPenetration> initial_penetrations_;
  std::vector<std::optional<FilledMass>> filled_masses_;
  std::vector<Body> bodies_;
  std::vector<BoundaryConditions> boundary_conditions_;  // of each body
  Processor processor_;
  std::vector<OnDevice> on_device_;  // each body, if there is a device
  std::optional<ShortRange> fragments_;
  std::optional<ShortRangeOnDevice> fragments_on_device_;
  Stability stability_;
  Clock clock_;  // counts increments with time.relax
  std::optional<Relaxation> relaxation_;
  std::vector<Impactor> impactors_;
  std::vector<MovingWindow> windows_;
  long load_steps_;                          // averaging interval of panel loads
  std::vector<std::vector<double>> travel_;  // [m] travel of each body's blocks in this step
  Monitors monitors_;
  ProximityMonitor proximity_;
  fccda::Timers timers_;
  Traffic traffic_of_steps_;
  double waiting_in_forces_ = 0;  // [s]
};

}  // namespace perimpact
