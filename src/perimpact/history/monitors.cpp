#include "perimpact/history/monitors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "fccda/elastic/stress.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

namespace {

/// Energy from rounding in bodies at rest [J]: velocities of a hundred units in the last place of positions per step.
double energy_of_rounding(std::span<const Body> bodies, double dt) {
  double energy = 0;
  for (const Body& body : bodies) {
    double furthest = 0;
    for (const std::uint32_t slot : body.particles.slot_of()) furthest = std::max(furthest, largest_magnitude(body.particles.reference(slot)));
    furthest = body.particles.share().ranks().max(furthest);
    const double speed = 100 * std::numeric_limits<double>::epsilon() * furthest / dt;
    energy += 0.5 * body.particles.mass_scaling() * body.particles.total_mass() * speed * speed;
  }
  return energy;
}

/// Limits the work of a long run after it has become invalid.
constexpr long most_steps_unchecked = 200;

constexpr ColumnKind instantaneous = ColumnKind::instantaneous, interval_mean = ColumnKind::interval_mean, cumulative = ColumnKind::cumulative;

/// On a particle, by an impactor.
struct Push {
  std::size_t slot;
  Vec3d impulse;  // [N s]
};

/// Those of the step, by slot.
std::vector<Push> pushes_on(std::size_t body, std::span<const Impactor> impactors) {
  std::vector<Push> pushes;
  for (const Impactor& impactor : impactors)
    for (const ContactImpulse& contact_impulse : impactor.contact_impulses_now())
      if (contact_impulse.body == body) pushes.push_back({*contact_impulse.slot, -contact_impulse.impulse});
  std::stable_sort(pushes.begin(), pushes.end(), [](const Push& a, const Push& b) { return a.slot < b.slot; });
  return pushes;
}

/// [J] contribution of contact to the kinetic energy of a body at the end of the step, not included in its forces: half of the impulse,
/// assumed constant.
double contact_share(std::size_t body, const Particles& particles, std::span<const Impactor> impactors, double dt) {
  const std::vector<Push> pushes = pushes_on(body, impactors);
  std::vector<std::uint32_t> slots;
  std::vector<double> energies;  // [J] of each
  for (auto push = pushes.begin(); push != pushes.end();) {
    const std::size_t slot = push->slot;
    Vec3d impulse{};
    for (; push != pushes.end() && push->slot == slot; ++push) impulse += push->impulse;
    const Vec3d velocity = particles.velocity.at(slot) + (0.5 * dt / particles.density()) * particles.force_density.at(slot);
    slots.push_back(static_cast<std::uint32_t>(slot));
    energies.push_back(0.5 * dot(impulse, velocity + 0.25 * (impulse / particles.mass(slot))));
  }
  return exact_sum_over_eights(particles.share().ranks(), slots, [&](std::size_t k) { return energies[k]; });
}

}  // namespace

Monitors::Monitors(const OutputSetup& setup, std::span<const Body> bodies, const Clock& clock)
    : interval_(std::max(
          1L, setup.history_interval ? std::lround(std::min(*setup.history_interval / clock.dt, static_cast<double>(clock.steps))) : clock.steps / 100)),
      check_interval_(std::clamp(clock.steps / 100, 1L, most_steps_unchecked)),
      elastic_(bodies.size(), 0.0),
      kinetic_(bodies.size(), 0.0) {
  for (const ProbeSetup& probe : setup.probes) {
    const auto body = std::find_if(bodies.begin(), bodies.end(), [&](const Body& candidate) { return candidate.name == probe.body; });
    const std::string key = "output.probes." + probe.name;
    if (body == bodies.end()) throw SetupError(key + ".body", fmt::format("probe {} refers to body {}, which does not exist.", probe.name, probe.body));
    probes_.push_back({probe.name, static_cast<std::size_t>(body - bodies.begin()), Sample(*body, probe.at)});
    const double away = probes_.back().sample.distance(), spacing = body->particles.spacing();
    if (away > spacing)
      throw SetupError(key + ".at",
                       fmt::format("probe {} lies {:.3g} m from the nearest particle of body {}, more than its spacing of {:.3g} m; move it into the body.",
                                   probe.name, away, probe.body, spacing));
  }
}

std::vector<std::uint32_t> Monitors::slots_read(std::size_t body, std::span<const Impactor> impactors, const Clock& clock) const {
  std::vector<std::uint32_t> slots;
  for (const Push& push : pushes_on(body, impactors)) slots.push_back(static_cast<std::uint32_t>(push.slot));
  if (is_due(clock))
    for (const Probe& probe : probes_)
      if (probe.body == body) std::ranges::copy(probe.sample.slots(), std::back_inserter(slots));
  return slots;
}

void Monitors::add(std::string_view owner, const Of& of, double value) {
  if (is_first_) {
    const std::string name = owner.empty() ? std::string(of.name) : fmt::format("{}.{}", owner, of.name);
    columns_.push_back({name, std::string(of.unit), of.kind, std::string(of.meaning), of.is_load});
  }
  row_.push_back(value);
}

void Monitors::add(std::string_view owner, const Of& of, const Vec3d& value) {
  for (std::size_t c = 0; c < 3; ++c) {
    const std::string name = is_first_ ? fmt::format("{}_{}", of.name, "xyz"[c]) : std::string();
    add(owner, {name, of.unit, of.kind, of.meaning, of.is_load}, value[c]);
  }
}

void Monitors::add_mean(std::string_view owner, const Of& of, double sum) {
  if (is_first_) sums_.push_back(sum);
  double& before = sums_[next_sum_++];
  add(owner, of, per_second_ * (sum - before));
  before = sum;
}

void Monitors::add_mean(std::string_view owner, const Of& of, const Vec3d& sum) {
  for (std::size_t c = 0; c < 3; ++c) {
    const std::string name = is_first_ ? fmt::format("{}_{}", of.name, "xyz"[c]) : std::string();
    add_mean(owner, {name, of.unit, of.kind, of.meaning, of.is_load}, sum[c]);
  }
}

void Monitors::watch(const Scene& scene) {
  const Balance balance = balance_of(scene);
  if (is_first_) first_energy_ = balance.energy - balance.elsewhere - balance.work - balance.from_elsewhere, first_balance_ = balance.sum();
  if (is_renewed_) renew_balance(balance.sum() - latest_balance_);
  latest_balance_ = balance.sum();
  if (is_checked(scene.clock) || scene.relaxed) {
    check_numbers(scene, balance.energy);
    // The forces lack the contribution of an impactor, so that the half kick adds spurious energy; an unstable step increases both.
    // Loads on a structure of another program are unknown here; what counts is its work on the bodies.
    if (!scene.relaxed)
      check_energy(scene, balance.energy - balance.elsewhere - std::max(0.0, balance.since_amid), balance.work + balance.from_elsewhere, balance.unpaid,
                   balance.contact);
    sound_until_ = scene.clock.step;
  }
  if (is_due(scene.clock)) make_row(scene, balance);
  is_first_ = false;
}

void Monitors::renew_balance(double change) {
  first_energy_ += change;
  first_balance_ += change;
  discarded_energy_ -= change;
  is_renewed_ = false;
}

// Contact with a structure that does not report its energy is external work.
void Monitors::add_structure(const DeformingPart& part, double contact_work, Balance& of) {
  of.energy += part.elastic_energy();
  of.taken += part.damping_dissipation();
  if (!part.external()) return;
  if (const std::optional<double> energy = part.external()->energy()) {
    of.energy += *energy;
    of.elsewhere += *energy;
    of.from_elsewhere -= contact_work;
  } else {
    of.work -= contact_work;
  }
}

Monitors::Balance Monitors::balance_of(const Scene& scene) {
  Balance of;
  const double dt = scene.clock.dt;
  for (const Impactor& impactor : scene.impactors) {
    of.momentum += impactor.body().momentum();
    const double kinetic = impactor.kinetic_energy();
    of.energy += kinetic;
    of.ripple += kinetic - impactor.kinetic_energy_of_scheme();
    if (const DeformingPart* part = impactor.deforming()) add_structure(*part, impactor.contact_work(), of);
    of.work += impactor.constraint_work() + impactor.load_work() + impactor.water_work();
    of.contact -= impactor.contact_work() + impactor.work_on_particles();
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    const BoundaryConditions& boundary_conditions = scene.boundary_conditions[b];
    const MotionSums& motion = scene.motion[b];
    const double kinetic = kinetic_[b] = scene.relaxed ? 0 : motion.kinetic_energy + contact_share(b, body.particles, scene.impactors, dt);
    of.momentum += motion.momentum;
    of.energy += kinetic + elastic_[b];
    of.work += boundary_conditions.work();
    of.unpaid += boundary_conditions.half_kick(scene.clock.time(), dt);
    of.ripple += scene.relaxed ? 0 : kinetic - motion.kinetic_energy_of_scheme;
    of.since_amid += scene.relaxed ? 0 : kinetic - motion.kinetic_energy_amid_step;
    of.taken += body.internal.fracture_energy() + body.internal.plastic_dissipation();
    of.contact -= boundary_conditions.constraint_work_correction();
  }
  if (scene.fragments) {
    of.energy += scene.fragments->energy();
    of.taken += scene.fragments->friction_dissipation() + scene.fragments->dashpot_dissipation() + scene.fragments->compaction_dissipation();
  }
  return of;
}

void Monitors::make_row(const Scene& scene, const Balance& balance) {
  row_.clear();
  next_sum_ = 0;
  const double time = scene.clock.time(), interval = time - row_time_;
  per_second_ = interval > 0 ? 1 / interval : 0;  // no action before the first row
  row_time_ = time;
  add("", {"time", "s", instantaneous, "end of the step"}, time);
  for (const Impactor& impactor : scene.impactors) add_impactor(impactor);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) add_body(scene, b);
  if (scene.fragments) {
    add("total", {"contact_energy", "J", instantaneous, "of the penalty springs between particles in contact"}, scene.fragments->energy());
    add("total", {"friction_dissipation", "J", cumulative, "dissipated by friction between particles in contact"}, scene.fragments->friction_dissipation());
    add("total", {"dashpot_dissipation", "J", cumulative, "dissipated by dashpots between particles in contact"}, scene.fragments->dashpot_dissipation());
    if (scene.fragments->yields())
      add("total", {"compaction_dissipation", "J", cumulative, "dissipated where fragments in contact are compacted"},
          scene.fragments->compaction_dissipation());
  }
  add("total", {"momentum", "kg m/s", instantaneous, "of all bodies and impactors"}, balance.momentum);
  add("total", {"energy", "J", instantaneous, "kinetic and elastic energy, and contact energy between fragments"}, balance.energy);
  for (const MovingWindow& window : scene.windows)
    add(window.name(), {"window_travel", "m", instantaneous, "of its moving window, along the axis of the window"}, window.travel());
  if (!scene.windows.empty())
    add("total", {"discarded_energy", "J", cumulative, "that left with the material discarded by moving windows, less that of the material added"},
        discarded_energy_);
  if (!scene.impactors.empty())
    add("total", {"contact_dissipation", "J", cumulative, "dissipated by contact with impactors, of impactors and bodies together"}, balance.contact);
  if (!scene.relaxed)
    add("total", {"energy_balance_error", "J", instantaneous, "current energy plus dissipation, minus initial energy and external work"},
        balance.sum() - first_balance_);
  if (scene.relaxed) {
    add("total", {"residual", "-", instantaneous, "residual at the end of the increment"}, scene.relaxed->residual);
    add("total", {"iterations", "-", instantaneous, "iterations of the increment"}, static_cast<double>(scene.relaxed->iterations));
  }
  for (const Probe& probe : probes_)
    add(probe.name, {"displacement", "m", instantaneous, "mean of the particles nearest to the point"}, probe.sample.displacement(scene.bodies[probe.body]));
  largest_.resize(row_.size());
  for (std::size_t c = 0; c < row_.size(); ++c)
    if (const double magnitude = std::fabs(row_[c]); !(magnitude <= largest_[c])) largest_[c] = magnitude;
}

void Monitors::add_impactor(const Impactor& impactor) {
  const fccda::RigidBody& body = impactor.body();
  const Account& account = impactor.account();
  const std::string& name = impactor.name();
  add(name, {"position", "m", instantaneous, "of its centre of mass"}, body.position_of_com());
  add(name, {"velocity", "m/s", instantaneous, "of its centre of mass"}, body.velocity());
  add(name, {"angular_velocity", "rad/s", instantaneous, "in global axes"}, body.angular_velocity());
  add(name, {"kinetic_energy", "J", instantaneous, "of translation and rotation"}, impactor.kinetic_energy());
  add_mean(name, {"force", "N", interval_mean, "of contact on it", true}, account.impulse);
  add_mean(name, {"moment", "N m", interval_mean, "of contact on it about its centre of mass"}, account.angular_impulse);
  add(name, {"contacts", "-", instantaneous, "particles in contact in the last step"}, static_cast<double>(account.contacts));
  add(name, {"contact_work", "J", cumulative, "done on it by contact"}, impactor.contact_work());
  if (impactor.crushes())
    add(name, {"crushing_dissipation", "J", cumulative, "dissipated by crushing particles, a part of total.contact_dissipation"},
        impactor.crushing_dissipation());
  if (const DeformingPart* part = impactor.deforming()) add_structure_columns(name, *part);
  if (impactor.water()) {
    add_mean(name, {"water_force_z", "N", interval_mean, "of weight, buoyancy and their damping"}, account.water_impulse);
    add_mean(name, {"water_moment_x", "N m", interval_mean, "of buoyancy and damping about its centre of mass"}, account.water_angular_impulse.x);
    add_mean(name, {"water_moment_y", "N m", interval_mean, "of buoyancy and damping about its centre of mass"}, account.water_angular_impulse.y);
    add(name, {"displaced_mass", "kg", instantaneous, "of the water that it displaces"}, impactor.water()->density * impactor.hydrostatics().volume);
  }
  for (const NamedGauge& named : impactor.gauges()) {
    const fccda::Gauge::Reading& reading = named.gauge.reading();
    add_mean(named.name, {"force", "N", interval_mean, "of contact on the parts of the gauge", true}, reading.impulse);
    add_mean(named.name, {"moment", "N m", interval_mean, "of that about the point of the gauge"}, reading.angular_impulse);
    if (named.gauge.has_axis()) add_mean(named.name, {"torque", "N m", interval_mean, "of that about the axis of the gauge", true}, reading.about_axis);
  }
}

void Monitors::add_structure_columns(const std::string& name, const DeformingPart& part) {
  if (part.elastic()) {
    add(name, {"elastic_energy", "J", instantaneous, "of its modes"}, part.elastic_energy());
    add(name, {"damping_dissipation", "J", cumulative, "dissipated by the damping of its modes"}, part.damping_dissipation());
    add(name, {"largest_deflection", "m", instantaneous, "of a vertex"}, part.largest_deflection());
    if (fccda::have_stresses(part.elastic()->modes()))
      add(name, {"largest_von_mises_stress", "Pa", instantaneous, "at a vertex"}, fccda::largest_von_mises(*part.elastic()));
  } else if (const std::optional<double> energy = part.external()->energy()) {
    add(name, {"structure_energy", "J", instantaneous, "as reported by the program that advances it"}, *energy);
  }
}

void Monitors::add_body(const Scene& scene, std::size_t b) {
  const Body& body = scene.bodies[b];
  add(body.name, {"kinetic_energy", "J", instantaneous, "of its particles"}, kinetic_[b]);
  add(body.name, {"elastic_energy", "J", instantaneous, "of its bonds"}, elastic_[b]);
  add(body.name, {"broken_bonds", "-", cumulative, "each counted once"}, static_cast<double>(body.internal.broken_bonds()));
  add(body.name, {"fracture_energy", "J", cumulative, "energy of the broken bonds at failure"}, body.internal.fracture_energy());
  if (body.internal.plastic()) add(body.name, {"plastic_dissipation", "J", cumulative, "dissipated by plastic flow"}, body.internal.plastic_dissipation());
  for (const NamedBoundaryCondition& named : scene.boundary_conditions[b].all()) {
    const ReactionLedger& account = named.account();
    if (scene.relaxed)
      add(named.name, {"force", "N", instantaneous, "on the body"}, account.force());
    else
      add_mean(named.name, {"force", "N", interval_mean, "on the body"}, account.impulse());
    add(named.name, {"work", "J", cumulative, "done on the body"}, account.work());
    if (const auto* water = std::get_if<Floating>(&named.boundary)) {
      add(named.name, {"weight_buoyancy_work", "J", cumulative, "done on the body by these"}, water->weight_buoyancy_work());
      add(named.name, {"drag_work", "J", cumulative, "done on the body by drag, damping and added mass"}, water->drag_work());
      if (water->has_dry_top())
        add(named.name, {"flooding_dissipation", "J", cumulative, "lost by water that floods tops that were dry"}, water->flooding_dissipation());
    }
  }
}

void Monitors::check_numbers(const Scene& scene, double energy) const {
  const Clock& clock = scene.clock;
  if (std::isfinite(energy)) return;
  for (const Body& body : scene.bodies)
    for (std::size_t i = 0; i < body.particles.size(); ++i) {
      const std::uint32_t slot = body.particles.slot_of()[i];
      if (!is_finite(body.particles.position.at(slot)) || !is_finite(body.particles.force_density.at(slot)))
        throw fccda::RunError(fmt::format(
            "At step {} ({:.6g} s) particle {} of {} has a position or force that is not a number. Output up to step {} is valid; use a smaller time step.",
            clock.step, clock.time(), i, body.name, sound_until_));
    }
  // in a run of several ranks the particle may be that of another
  throw fccda::RunError(fmt::format("At step {} ({:.6g} s) the energy is not a number. Output up to step {} is valid; use a smaller time step.", clock.step,
                                    clock.time(), sound_until_));
}

void Monitors::check_energy(const Scene& scene, double energy, double work, double unpaid, double contact_dissipation) const {
  const Clock& clock = scene.clock;
  // Contact and fracture only dissipate. Interpolated velocities cause a ripple of (ω dt)² on the energy of the shortest waves, which is small.
  const double available = first_energy_ + std::fabs(work) + energy_of_rounding(scene.bodies, clock.dt) + unpaid;
  const double excess = energy - work - first_energy_ - unpaid;
  if (!(excess > 0.05 * available)) return;
  const std::string discarded = discarded_energy_ == 0 ? "" : fmt::format(", less {:.4g} J that moving windows discarded", discarded_energy_);
  std::string sentence = fmt::format(
      "At step {} ({:.6g} s) the energy is {:.4g} J, {:.3g} J more than the initial {:.4g} J plus {:.4g} J of external work{}: the time step of {:.3g} s is "
      "unstable for this run; reduce it.",
      clock.step, clock.time(), energy, energy - work - first_energy_, first_energy_ + discarded_energy_, work, discarded, clock.dt);
  if (-contact_dissipation > 0.5 * excess)
    sentence += fmt::format(
        " Contact with impactors added {:.3g} J: particles slide over an edge or tip that is sharper than their spacing, and move too far per step. Use a "
        "time.step of {:.2g} s, and smaller ones until total.contact_dissipation stays above 0.",
        -contact_dissipation, clock.dt / 4);
  throw fccda::RunError(sentence);
}

}  // namespace perimpact
