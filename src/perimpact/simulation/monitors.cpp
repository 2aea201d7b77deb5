#include "perimpact/simulation/monitors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "perimpact/setup/setup_error.hpp"

namespace perimpact {

namespace {

/// What rounding can put into bodies at rest [J]: velocities that move particles by a hundred units in the last place a step.
double energy_of_rounding(std::span<const Body> bodies, double dt) {
  double energy = 0;
  for (const Body& body : bodies) {
    double furthest = 0;
    for (const std::uint32_t slot : body.particles.slot_of()) furthest = std::max(furthest, largest_magnitude(body.particles.reference(slot)));
    const double speed = 100 * std::numeric_limits<double>::epsilon() * furthest / dt;
    energy += 0.5 * body.particles.total_mass() * speed * speed;
  }
  return energy;
}

/// [J] with the velocities that led here, half a step old.
double kinetic_energy_amid_step(const Particles& particles) {
  double energy = 0;
  for (const std::uint32_t slot : particles.slot_of()) energy += 0.5 * particles.mass(slot) * squared_norm(particles.velocity.at(slot));
  return energy;
}

/// [J] that contact adds to the kinetic energy of a body at the end of the step, where forces at hand know nothing of it: half of a push that is
/// taken to go on as it was in the step.
double contact_share(std::size_t body, const Particles& particles, std::span<const Impactor> impactors, double dt) {
  struct Push {
    std::size_t slot;
    Vec3d impulse;  // [N s]
  };
  std::vector<Push> pushes;
  for (const Impactor& impactor : impactors)
    for (const Blow& blow : impactor.lasting_blows())
      if (blow.body == body) pushes.push_back({blow.contact.point, -blow.impulse});
  std::stable_sort(pushes.begin(), pushes.end(), [](const Push& a, const Push& b) { return a.slot < b.slot; });
  double energy = 0;
  for (auto push = pushes.begin(); push != pushes.end();) {
    const std::size_t slot = push->slot;
    Vec3d impulse{};
    for (; push != pushes.end() && push->slot == slot; ++push) impulse += push->impulse;
    const Vec3d velocity = particles.velocity.at(slot) + (0.5 * dt / particles.density()) * particles.force_density.at(slot);
    energy += 0.5 * dot(impulse, velocity + 0.25 * (impulse / particles.mass(slot)));
  }
  return energy;
}

}  // namespace

Monitors::Monitors(const OutputSetup& setup, std::span<const Body> bodies, const Clock& clock)
    : interval_(std::max(1L, setup.history ? std::lround(std::min(*setup.history / clock.dt, static_cast<double>(clock.steps))) : clock.steps / 100)),
      elastic_(bodies.size(), 0.0) {
  for (const ProbeSetup& probe : setup.probes) {
    const auto body = std::find_if(bodies.begin(), bodies.end(), [&](const Body& candidate) { return candidate.name == probe.body; });
    const std::string key = "output.probes." + probe.name;
    if (body == bodies.end()) throw SetupError(key + ".body", fmt::format("probe {} asks for body {}, which does not exist.", probe.name, probe.body));
    probes_.push_back({probe.name, static_cast<std::size_t>(body - bodies.begin()), Sample(*body, probe.at)});
    const double away = probes_.back().sample.distance(*body), spacing = body->particles.spacing();
    if (away > spacing)
      throw SetupError(key + ".at",
                       fmt::format("probe {} lies {:.3g} m from the nearest particle of body {}, more than its spacing of {:.3g} m; move it into the body.",
                                   probe.name, away, probe.body, spacing));
  }
}

void Monitors::add(const std::string& column, double value) {
  if (is_first_) columns_.push_back(column);
  row_.push_back(value);
}

void Monitors::add_vector(const std::string& owner, const char* quantity, const char* unit, const Vec3d& value) {
  constexpr const char* axes = "xyz";
  for (std::size_t c = 0; c < 3; ++c) add(fmt::format("{}.{}_{} [{}]", owner, quantity, axes[c], unit), value[c]);
}

void Monitors::record(std::span<const Body> bodies, std::span<Boundaries> boundaries, std::span<Impactor> impactors, const Clock& clock, const Relaxed* relaxed,
                      const std::optional<ShortRange>& fragments) {
  row_.clear();
  add("time [s]", clock.time());
  const double interval = clock.time() - row_time_;  // forces are means over it; nothing has acted before the first row
  const double per_second = interval > 0 ? 1 / interval : 0;
  row_time_ = clock.time();

  Vec3d momentum{};
  double energy = 0, work = 0, unpaid = 0;
  double ripple = 0, taken = 0, contact_loss = 0;  // [J] for the balance
  double since_amid = 0;                           // [J] that the half kick to this instant gave
  for (Impactor& impactor : impactors) {
    const fccda::RigidBody& body = impactor.body();
    Account& account = impactor.account();
    add_vector(impactor.name(), "position", "m", body.position_of_com());
    add_vector(impactor.name(), "velocity", "m/s", body.velocity());
    add_vector(impactor.name(), "angular_velocity", "rad/s", body.angular_velocity());
    add_vector(impactor.name(), "force", "N", per_second * account.impulse);
    add_vector(impactor.name(), "moment", "N m", per_second * account.angular_impulse);
    add(impactor.name() + ".contacts [-]", static_cast<double>(account.contacts));
    add(impactor.name() + ".contact_work [J]", impactor.work_of_contact());
    account.impulse = {}, account.angular_impulse = {};
    if (impactor.water()) {
      add(impactor.name() + ".water_force_z [N]", per_second * account.water_impulse);
      add(impactor.name() + ".water_moment_x [N m]", per_second * account.water_angular_impulse.x);
      add(impactor.name() + ".water_moment_y [N m]", per_second * account.water_angular_impulse.y);
      add(impactor.name() + ".displaced_mass [kg]", impactor.water()->density * impactor.afloat().volume);
      account.water_impulse = 0, account.water_angular_impulse = {};
    }
    for (NamedGauge& named : impactor.gauges()) {
      const fccda::Gauge::Reading& reading = named.gauge.reading();
      add_vector(named.name, "force", "N", per_second * reading.impulse);
      add_vector(named.name, "moment", "N m", per_second * reading.angular_impulse);
      if (named.gauge.has_axis()) add(named.name + ".torque [N m]", per_second * reading.about_axis);
      named.gauge.reset();
    }
    impactor.record().end_interval(clock.time(), interval);
    momentum += body.momentum();
    const double kinetic = impactor.kinetic_energy();
    energy += kinetic;
    ripple += kinetic - body.kinetic_energy();
    work += impactor.work_of_holder() + impactor.work_of_loads() + impactor.work_of_water();
    contact_loss -= impactor.work_of_contact() + impactor.work_on_particles();
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double kinetic = relaxed ? 0 : bodies[b].kinetic_energy(clock.dt) + contact_share(b, bodies[b].particles, impactors, clock.dt);
    add(bodies[b].name + ".kinetic_energy [J]", kinetic);
    add(bodies[b].name + ".elastic_energy [J]", elastic_[b]);
    add(bodies[b].name + ".broken_bonds [-]", static_cast<double>(bodies[b].internal.broken_bonds()));
    add(bodies[b].name + ".fracture_energy [J]", bodies[b].internal.fracture_energy());
    for (NamedBoundary& named : boundaries[b].all()) {
      add_vector(named.name, "force", "N", per_second * named.account().take_impulse());
      add(named.name + ".work [J]", named.account().work());
      if (const auto* water = std::get_if<Floating>(&named.boundary)) {
        add(named.name + ".work_of_weight_and_buoyancy [J]", water->work_of_weight_and_buoyancy());
        add(named.name + ".work_of_drag [J]", water->work_of_drag());
      }
    }
    momentum += bodies[b].momentum();
    energy += kinetic + elastic_[b];
    work += boundaries[b].work();
    unpaid += boundaries[b].half_kick(clock.time(), clock.dt);
    ripple += relaxed ? 0 : kinetic - bodies[b].kinetic_energy_of_scheme(clock.dt);
    since_amid += relaxed ? 0 : kinetic - kinetic_energy_amid_step(bodies[b].particles);
    taken += bodies[b].internal.fracture_energy();
    contact_loss -= boundaries[b].undone();
  }
  if (fragments) {
    add("total.contact_energy [J]", fragments->energy());
    add("total.friction_work [J]", fragments->friction_work());
    add("total.restitution_work [J]", fragments->restitution_work());
    energy += fragments->energy();
    taken += fragments->friction_work() + fragments->restitution_work();
  }
  add_vector("total", "momentum", "kg m/s", momentum);
  add("total.energy [J]", energy);
  if (!impactors.empty()) add("total.contact_loss [J]", contact_loss);
  if (!relaxed) {
    const double balance = energy - ripple + taken + contact_loss - work;
    if (is_first_) first_balance_ = balance;
    add("total.closing_error [J]", balance - first_balance_);
  }
  if (relaxed) {
    add("total.residual [-]", relaxed->residual);
    add("total.iterations [-]", static_cast<double>(relaxed->iterations));
  }
  for (const Probe& probe : probes_) add_vector(probe.name, "displacement", "m", probe.sample.displacement(bodies[probe.body]));
  if (is_first_) first_energy_ = energy - work;
  check_numbers(bodies, clock, energy);
  // Where an impactor presses, the forces at hand lack its share, and the half kick gives energy that is not there; an unstable step blows up both.
  if (!relaxed) check_energy(bodies, clock, energy - std::max(0.0, since_amid), work, unpaid, contact_loss);
  is_first_ = false;
}

void Monitors::check_numbers(std::span<const Body> bodies, const Clock& clock, double energy) const {
  if (std::isfinite(energy)) return;
  for (const Body& body : bodies)
    for (std::size_t i = 0; i < body.particles.size(); ++i) {
      const std::uint32_t slot = body.particles.slot_of()[i];
      if (!is_finite(body.particles.position.at(slot)) || !is_finite(body.particles.force_density.at(slot)))
        throw fccda::RunError(
            fmt::format("At step {} ({:.6g} s) particle {} of {} has a position or force that is not a number. The rows written before are sound; try a "
                        "smaller time step.",
                        clock.step, clock.time(), i, body.name));
    }
  throw fccda::RunError(
      fmt::format("At step {} ({:.6g} s) the energy is not a number. The rows written before are sound; try a smaller time step.", clock.step, clock.time()));
}

void Monitors::check_energy(std::span<const Body> bodies, const Clock& clock, double energy, double work, double unpaid, double contact_loss) const {
  // Contact and breaking only take energy. Interpolated velocities leave a ripple of (ω dt)² on the energy of the shortest waves, which hold little of it.
  const double available = first_energy_ + std::fabs(work) + energy_of_rounding(bodies, clock.dt) + unpaid;
  const double excess = energy - work - first_energy_ - unpaid;
  if (!(excess > 0.05 * available)) return;
  std::string sentence = fmt::format(
      "At step {} ({:.6g} s) the energy is {:.4g} J, {:.3g} J more than the {:.4g} J there were plus the {:.4g} J put in from outside: the time step of {:.3g} "
      "s "
      "is not stable for this run; make it smaller.",
      clock.step, clock.time(), energy, energy - work - first_energy_, first_energy_, work, clock.dt);
  if (-contact_loss > 0.5 * excess)
    sentence += fmt::format(
        " Contact with impactors put in {:.3g} J: particles slide over an edge or a tip that is sharper than their spacing, and go too far in a step. Take a "
        "time.step of {:.2g} s, and smaller ones until total.contact_loss stays above 0.",
        -contact_loss, clock.dt / 4);
  throw fccda::RunError(sentence);
}

}  // namespace perimpact
