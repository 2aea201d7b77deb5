#include "perimpact/simulation/simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "fccda/respond/resolve_together.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/device/device.hpp"
#include "perimpact/diagnostics/setup_warnings.hpp"
#include "perimpact/discretisation/particle_set.hpp"
#include "perimpact/moving_window/moved_state.hpp"
#include "perimpact/simulation/short_range_of.hpp"
#include "perimpact/simulation/state_hash.hpp"

namespace perimpact {

namespace {

std::vector<Body> make_bodies(const Setup& setup, std::vector<Particles> particles, fccda::Stages& stages) {
  std::vector<Body> bodies;
  for (std::size_t b = 0; b < setup.bodies.size(); ++b) bodies.push_back(make_body(setup.bodies[b], std::move(particles[b]), stages));
  return bodies;
}

std::vector<BoundaryConditions> make_boundary_conditions(const Setup& setup, std::span<const Body> bodies, std::vector<UserForceOnBody> user_forces) {
  std::vector<BoundaryConditions> boundary_conditions;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const BodySetup& body = setup.bodies[b];
    const Particles& particles = bodies[b].particles;
    boundary_conditions.emplace_back(body, elastic_of(body), particles,
                                     [&](const std::string& region, const std::string& key) { return slots_in(region, body, particles, key); });
  }
  for (UserForceOnBody& given : user_forces) {
    if (bodies[given.body].particles.share().ranks().size() > 1)
      throw fccda::InputError(fmt::format("user forces such as {} are not supported in a run of several ranks; run one process.", given.name));
    if (setup.time.relax)
      throw SetupError(
          "time.relax",
          fmt::format("user forces such as {} are not supported with time.relax; remove time.relax, or use boundary conditions of the deck.", given.name));
    if (setup.bodies[given.body].moving_window)
      throw SetupError("bodies." + setup.bodies[given.body].name + ".moving_window",
                       fmt::format("user forces such as {} are not supported on a body with a moving window; remove one of them.", given.name));
    const Body& body = bodies[given.body];  // has a stable address for the lifetime of the simulation
    boundary_conditions[given.body].add({body.name + "." + given.name, "user_force",
                                         UserForce(body.name + "." + given.name, body.particles,
                                                   [act = std::move(given.function), &body](double time, VectorArray& density) { act(time, body, density); })});
  }
  return boundary_conditions;
}

void expect_solid_bodies(std::span<const Body> bodies, std::span<const Impactor> impactors) {
  for (const Impactor& impactor : impactors)
    for (const Body& body : bodies)
      if (impactor.deforming() && body.particles.is_plane())
        throw SetupError("impactors." + impactor.name(),
                         fmt::format("impactor {} deforms, but body {} is plane, and contact in a plane needs a prismatic surface; make the body solid, or the "
                                     "impactor rigid.",
                                     impactor.name(), body.name));
}

std::optional<Relaxation> make_relaxation(const Setup& setup, std::span<const Body> bodies, double dt) {
  if (!setup.time.relax) return std::nullopt;
  if (!setup.impactors.empty())
    throw SetupError(
        "impactors." + setup.impactors.front().name,
        fmt::format("impactor {} is not supported with time.relax; prescribe the displacement of the particles in contact instead, or remove time.relax.",
                    setup.impactors.front().name));
  return Relaxation(*setup.time.relax, bodies, dt);
}

/// With time.relax, each increment is a row.
OutputSetup output_of(const Setup& setup, double dt) {
  OutputSetup output = setup.output;
  if (setup.time.relax) output.history_interval = dt;
  return output;
}

/// [s] Transit time of a wave through the slowest family, δ/√(E/ρ), the response time of particles. Under steady pressure a particle receives
/// an impulse once in several steps, so that the pressure of a single step depends on the step; averaged over this time it does not.
double response_time(const Setup& setup, std::span<const Body> bodies) {
  double time = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    time = std::max(time, bodies[b].family.horizon() * std::sqrt(bodies[b].particles.density() / elastic_of(setup.bodies[b]).youngs_modulus));
  return time;
}

const Setup& checked_for(const Processor& processor, const Ranks& ranks, const Setup& setup) {
  if (!processor.device) return setup;
  if (ranks.size() > 1) throw fccda::InputError("--device is not supported in a run of several ranks; omit it, or run one process.");
  expect_supported_by_devices(setup);
  return setup;
}

/// Resolver of contact between an impactor and one body, for fccda::resolve_together.
struct ImpactorOnBody {
  Impactor& impactor;
  std::size_t body;

  std::span<const fccda::Contact> resolve_contact(ContactParticles& particles) { return impactor.resolve_contact(body, particles); }
  std::span<const fccda::Contact> resolve_contact_again(ContactParticles& particles, std::span<const std::size_t> which) {
    return impactor.resolve_contact_again(body, particles, which);
  }
  std::vector<std::size_t> still_inside(const ContactParticles& particles, std::span<const std::size_t> which) {
    return impactor.still_inside(body, particles, which);
  }
  void moved(std::size_t particle) { impactor.moved(body, particle); }
};

void make_crushable(Particles& particles, const ImpactorContactSetup& contact) {
  if (contact.crushing_pressure) particles.crushed = CrushedMaterial(2 * contact.radius_ratio * particles.spacing(), particles.slots());
}

}  // namespace

Simulation::Simulation(const Setup& setup, fccda::Stages::Announce announce, Ranks& ranks, std::span<const MeasuredLoad> loads, const Processor& processor)
    : Simulation(setup, Start(checked_for(processor, ranks, setup), fccda::Stages(std::move(announce)), ranks, loads), {}, processor) {}

Simulation::Simulation(const Setup& setup, Start start, std::vector<UserForceOnBody> user_forces, const Processor& processor)
    : ranks_(start.ranks),
      setup_(setup),
      stages_(std::move(start.stages)),
      initial_penetrations_(std::move(start.inside)),
      filled_masses_(std::move(start.filled_masses)),
      bodies_(make_bodies(setup, std::move(start.particles), stages_)),
      boundary_conditions_(make_boundary_conditions(setup, bodies_, std::move(user_forces))),
      processor_(processor),
      fragments_((stages_.begin("contact of fragments"), short_range_of(setup, bodies_))),
      stability_((stages_.begin("time step"), find_step(setup, bodies_, start.impactors, fragments_, warnings_))),
      clock_{stability_.step, std::max(1L, static_cast<long>(std::ceil(setup.time.end / stability_.step - 1e-6)))},
      relaxation_(make_relaxation(setup, bodies_, clock_.dt)),
      impactors_(std::move(start.impactors)),
      windows_(moving_windows_of(setup, bodies_, impactors_)),
      load_steps_(std::clamp(std::lround(std::min(response_time(setup, bodies_) / clock_.dt, 1e9)), 1L, clock_.steps)),
      monitors_(output_of(setup, clock_.dt), bodies_, clock_) {
  for (Body& body : bodies_) {
    travel_.emplace_back(travel_blocks(body.particles), 0.0);
    make_crushable(body.particles, setup.contact.impactors);
  }
  expect_solid_bodies(bodies_, impactors_);
  use_scalar_kernels();
  copy_to_device();
  stages_.begin("diagnostics");
  const auto warn = [&](std::vector<std::string> sentences) { std::ranges::move(sentences, std::back_inserter(warnings_)); };
  warn(warnings_about_bodies(setup_, bodies_, filled_masses_));
  warn(warnings_about_floating(setup_, bodies_, boundary_conditions_));
  warn(warnings_of(initial_penetrations_, setup_, bodies_));
  warn(warnings_about_impactors(setup_, bodies_, impactors_, clock_.dt));
  if (!relaxation_) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) boundary_conditions_[b].set_initial_state(bodies_[b].particles, 0, PrescribedDisplacement::Regime::moving);
    stages_.begin("initial forces");
    begin_refresh_ghosts();
    compute_bond_forces();
    add_short_range_forces();
    apply_boundary_conditions();
    if (fragments_ && fragments_->contacts() > 0) warnings_.push_back(warning_of_overlap(*fragments_));
  }
  sample_monitors();
  stages_.end();
}

void Simulation::copy_to_device() {
  if (!processor_.device) return;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    BodyOnDevice body(*processor_.device, bodies_[b]);
    BoundaryConditionsOnDevice boundary_conditions(*processor_.device, body, bodies_[b], boundary_conditions_[b]);
    on_device_.push_back({std::move(body), std::move(boundary_conditions)});
  }
  if (!fragments_) return;
  std::vector<BodyOnDevice*> all;
  for (OnDevice& one : on_device_) all.push_back(&one.body);
  fragments_on_device_.emplace(*processor_.device, all);
}

void Simulation::release_from_device() {
  bring_to_host();
  for (OnDevice& one : on_device_) one.boundary_conditions.record_to_host();
  if (fragments_on_device_) fragments_on_device_->to_host(*fragments_);
  fragments_on_device_.reset();
  on_device_.clear();
}

void Simulation::step(const KeepRelaxing& keep_on) {
  const Traffic before = ranks_->traffic();
  perform_step(keep_on);
  Traffic sent = ranks_->traffic();
  traffic_of_steps_ += sent -= before;
}

void Simulation::perform_step(const KeepRelaxing& keep_on) {
  if (!windows_.empty()) timers_.timed("moving_window", [&] { move_windows(); });
  ++clock_.step;
  if (relaxation_) return relax(keep_on);
  timers_.timed("predict", [&] { advance_bodies(); });
  timers_.timed("contact", [&] {
    resolve_impactor_contact();
    isolate_crushed();
    end_load_interval();
  });
  if (ranks_->size() > 1) timers_.timed("ghosts", [&] { begin_refresh_ghosts(); });
  time_forces("forces", [&] { compute_bond_forces(); });
  if (fragments_) time_forces("fragments", [&] { add_short_range_forces(); });
  timers_.timed("boundary_conditions", [&] { apply_boundary_conditions(); });
  timers_.timed("monitors", [&] {
    if (monitors_.samples_step(clock_)) sample_monitors();
  });
}

void Simulation::time_forces(std::string_view phase, const std::function<void()>& compute) {
  const double before = ranks_->traffic().seconds;
  timers_.timed(phase, compute);
  waiting_in_forces_ += ranks_->traffic().seconds - before;
}

std::string Simulation::device_name() const { return processor_.device ? processor_.device->name() : ""; }

double Simulation::seconds_of_forces() const {
  return timers_.seconds("forces") + timers_.seconds("fragments") + timers_.seconds("relax") - waiting_in_forces_;
}

// After rows of the history: the next interval of panel loads has not begun, so that no particle in contact in it is discarded.
void Simulation::move_windows() {
  if (!monitors_.is_due(clock_)) return;
  for (MovingWindow& window : windows_)
    if (const long moves = window.moves_due(impactors_); moves != 0) move_window(window, moves);
}

void Simulation::move_window(MovingWindow& window, long moves) {
  const auto visit_all = [&](auto& visit) {
    visit_parts(visit);
    visit_record(visit);
  };
  if (window.travel() == 0) window.expect_fixed_along(boundary_conditions_[window.body()], bodies_[window.body()].particles, moves);
  release_from_device();
  window.inspect_front(bodies_[window.body()], moves);
  CapturedState captured;
  visit_all(captured);
  window.move(moves);
  rebuild(window);
  const std::size_t b = window.body();
  const Body& body = bodies_[b];
  std::size_t slots_before = 0;
  for (std::size_t before = 0; before < b; ++before) slots_before += bodies_[before].particles.slots_of_whole();
  MovedState moved(captured, {body.name, b, slots_before, window.cells_of(moves), body.particles, body.family});
  visit_all(moved);
  window.continue_front(bodies_[b], moves);
  std::vector<std::size_t> crushed;  // new material has all its bonds, also with these
  for (const std::uint32_t slot : body.particles.slot_of())
    if (body.particles.crushed.is_crushed(slot)) crushed.push_back(body.particles.share().whole_slot(slot));
  isolate(b, ranks_->join_all(std::span<const std::size_t>(crushed)));
  boundary_conditions_[b].restart_potentials();
  for (Impactor& impactor : impactors_) impactor.forget_distances(b);
  window.expect_clear(bodies_, impactors_, setup_.contact.impactors, moves);
  monitors_.renew_balance();
  copy_to_device();
}

/// Rebuilds the body of the window at its cells, undeformed. Its parts keep their addresses, and its arrays theirs, to which programs may refer.
void Simulation::rebuild(const MovingWindow& window) {
  const std::size_t b = window.body();
  Body body = make_body(setup_.bodies[b], make_particles(setup_.bodies[b], bodies_[b].particles.share().at({})));
  boundary_conditions_[b] =
      BoundaryConditions(setup_.bodies[b], elastic_of(setup_.bodies[b]), body.particles,
                         [&](const std::string& set, const std::string& key) { return slots_in(set, setup_.bodies[b], body.particles, key); });
  make_crushable(body.particles, setup_.contact.impactors);
  body.particles.move_lattice(window.first());  // after what is chosen by position: it belongs to slots
  bodies_[b] = body;
  if (fragments_) fragments_ = short_range_of(setup_, bodies_);
  use_scalar_kernels();
}

void Simulation::use_scalar_kernels() {
  if (!processor_.is_scalar) return;
  for (Body& body : bodies_) body.internal.use_scalar_kernel();
  if (fragments_) fragments_->use_scalar_kernel();
}

void Simulation::advance_bodies() {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (OnDevice* const device = on_device(b)) {
      device->body.advance(bodies_[b].particles, clock_.dt, travel_[b]);
      device->boundary_conditions.impose_displacements(bodies_[b].particles, clock_.latest(), travel_[b]);
    } else {
      advance(bodies_[b].particles, clock_.dt, travel_[b]);
      boundary_conditions_[b].impose_displacements(bodies_[b].particles, clock_.latest(), travel_[b]);
    }
  }
}

void Simulation::resolve_impactor_contact() {
  for (Impactor& impactor : impactors_) impactor.advance(clock_.latest());
  std::vector<ContactParticles> particles;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    ContactParticles::Fetch fetch;
    if (OnDevice* const device = on_device(b)) fetch = [device](std::span<const std::uint32_t> slots) { device->body.to_host(slots); };
    particles.emplace_back(bodies_[b].particles, setup_.contact.impactors, travel_[b], clock_.dt, std::move(fetch));
  }
  std::vector<std::vector<std::size_t>> unresolved(bodies_.size());  // of each impactor
  // The motion of impactors depends on their contact impulses (docs/theory/contact_response.md, "One velocity"), hence the passes.
  for (int pass = 1;; ++pass) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) unresolved[b] = resolve_body(b, particles[b]);
    for (Impactor& impactor : impactors_) impactor.collect_contacts(*ranks_);
    if (pass == fccda::Coupling::max_passes || std::ranges::all_of(impactors_, &Impactor::moved_with_contact)) break;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      particles[b].undo([&](std::size_t slot) {
        for (Impactor& impactor : impactors_) impactor.moved(b, slot);
      });
    for (Impactor& impactor : impactors_) impactor.repeat_step(pass + 1 == fccda::Coupling::max_passes);
  }
  for (Impactor& impactor : impactors_) impactor.finish_step();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    for (std::size_t i = 0; i < impactors_.size(); ++i) {
      const bool may_remain = impactors_.size() > 1;  // between impactors
      const auto all = may_remain ? ranks_->sum(static_cast<std::int64_t>(unresolved[b][i])) : static_cast<std::int64_t>(unresolved[b][i]);
      impactors_[i].record_unresolved(b, static_cast<std::size_t>(all), clock_.time());
    }
    if (OnDevice* const device = on_device(b)) device->body.moved_on_host(particles[b].changed());  // among them all that are reimposed
    for (const std::uint32_t slot : boundary_conditions_[b].respond_to_contact(bodies_[b].particles, clock_.latest(), particles[b].changed()))
      for (Impactor& impactor : impactors_) impactor.put_back(b, slot);
  }
}

std::vector<std::size_t> Simulation::resolve_body(std::size_t body, ContactParticles& particles) {
  std::vector<ImpactorOnBody> resolvers;
  for (Impactor& impactor : impactors_) resolvers.push_back({impactor, body});
  std::vector<std::size_t> unresolved;
  for (const std::vector<std::size_t>& points : fccda::resolve_together(std::span(resolvers), particles)) unresolved.push_back(points.size());
  return unresolved;
}

/// Particles that impactors have crushed in this step lose their bonds, and their contact with others.
void Simulation::isolate_crushed() {
  const auto has_crushed = [](const Impactor& impactor) { return !impactor.last_step().crushed.empty(); };
  if (std::ranges::none_of(impactors_, has_crushed)) return;
  bring_to_host();
  for (const Impactor& impactor : impactors_)
    for (const auto& [b, whole_slot] : impactor.last_step().crushed) isolate(b, std::array{whole_slot});
  for (OnDevice& one : on_device_) one.body.renew();
  if (fragments_) fragments_->renew_list();
}

void Simulation::isolate(std::size_t b, std::span<const std::size_t> whole_slots) {
  Body& body = bodies_[b];
  for (const std::size_t whole_slot : whole_slots)
    if (const auto slot = body.particles.share().local_slot(whole_slot)) body.internal.isolate(*slot, body.particles, body.family);
}

void Simulation::begin_refresh_ghosts() {
  for (Body& body : bodies_) body.particles.begin_refresh_ghosts();
}

void Simulation::compute_bond_forces() {
  const double dt = clock_.step > 0 ? clock_.dt : 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
    const bool with_energy = monitors_.samples_step(clock_);
    if (OnDevice* const device = on_device(b)) {
      device->body.evaluate(body, dt, with_energy);
      if (with_energy) monitors_.elastic_energy()[b] = body.internal.elastic_energy();
    } else if (with_energy) {
      monitors_.elastic_energy()[b] = body.internal.evaluate_with_energy(body.particles, body.family, dt);
    } else {
      body.internal.evaluate(body.particles, body.family, dt);
    }
    body.particles.share().complete_refresh();  // if no loop over packs has done so
  }
}

void Simulation::add_short_range_forces() {
  if (!fragments_) return;
  const double dt = clock_.step > 0 ? clock_.dt : 0;
  if (fragments_on_device_)
    fragments_on_device_->add_forces(*fragments_, contacting_bodies(setup_, bodies_), dt);
  else
    fragments_->add_forces(contacting_bodies(setup_, bodies_), dt);
}

void Simulation::apply_boundary_conditions() {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
    if (OnDevice* const device = on_device(b)) {
      device->boundary_conditions.add_forces(body, clock_.next());
      continue;
    }
    boundary_conditions_[b].update_exposed_surface(body.particles, body.family, body.internal.broken_ends());
    boundary_conditions_[b].add_forces(body.particles, clock_.next());
  }
}

void Simulation::relax(const KeepRelaxing& keep_on) {
  std::optional<std::vector<double>> energy;
  time_forces("relax", [&] { energy = relaxation_->relax(bodies_, boundary_conditions_, clock_.step, clock_.time(), keep_on); });
  if (!energy) {
    --clock_.step;
    return;
  }
  monitors_.elastic_energy() = std::move(*energy);
  timers_.timed("monitors", [&] { sample_monitors(); });
}

void Simulation::end_load_interval() {
  if (clock_.step % load_steps_ != 0 && !clock_.is_finished()) return;
  // the last interval may be shorter; its mean is still taken over a full one
  for (Impactor& impactor : impactors_) impactor.end_load_interval(clock_.time(), static_cast<double>(load_steps_) * clock_.dt);
}

void Simulation::sample_monitors() {
  const std::vector<MotionSums> motion = motion_of_bodies();
  const double row_before = monitors_.row_time();
  monitors_.watch({bodies_, motion, boundary_conditions_, impactors_, clock_, fragments_, windows_, relaxation_ ? &relaxation_->latest() : nullptr});
  if (monitors_.is_due(clock_))
    for (Impactor& impactor : impactors_) impactor.end_history_interval(clock_.time(), clock_.time() - row_before);
  if (monitors_.is_checked(clock_)) proximity_.sample(bodies_, impactors_, setup_.contact.impactors.radius_ratio, clock_.time());
}

std::vector<MotionSums> Simulation::motion_of_bodies() {
  std::vector<MotionSums> motion;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    OnDevice* const device = on_device(b);
    if (!device) {
      motion.push_back(bodies_[b].motion(clock_.dt));
      continue;
    }
    motion.push_back(device->body.motion(bodies_[b], clock_.dt));
    const bool is_finite = std::isfinite(motion.back().kinetic_energy) && std::isfinite(monitors_.elastic_energy()[b]);
    if (!is_finite || (monitors_.is_checked(clock_) && ProximityMonitor::reads(b, impactors_)))
      device->body.to_host();
    else
      device->body.to_host(monitors_.slots_read(b, impactors_, clock_));
  }
  return motion;
}

std::size_t Simulation::contacts() const {
  std::size_t sum = 0;
  for (const Impactor& impactor : impactors_) sum += impactor.account().contacts;
  return sum;
}

std::vector<std::string> Simulation::closing_warnings() const {
  std::vector<std::string> warnings = proximity_.warnings(bodies_, impactors_);
  for (const MovingWindow& window : windows_) std::ranges::move(window.warnings(), std::back_inserter(warnings));
  for (const Impactor& impactor : impactors_)
    if (impactor.unconverged_steps() > 0)
      warnings.push_back(
          fmt::format("In {} steps the motion of impactor {} and its contact impulses did not agree within 10 % after {} passes, so that its forces are "
                      "inaccurate. Use a shorter time step.",
                      impactor.unconverged_steps(), impactor.name(), fccda::Coupling::max_passes));
  return warnings;
}

std::uint64_t Simulation::state_hash() {
  StateHash hash;  // of the root's arrays, and of each rank's part of those that ranks share
  HashOfRanks of_ranks(bodies(), *ranks_, hash);
  visit_state(of_ranks);
  return static_cast<std::uint64_t>(ranks_->sum(static_cast<std::int64_t>(hash.value())));
}

}  // namespace perimpact
