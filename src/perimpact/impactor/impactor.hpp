/// Impactor: rigid body, surface, contact detectors and ledgers; with a structure if its surface deforms.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/state.hpp"
#include "fccda/detect/all_detectors.hpp"
#include "fccda/respond/coupling.hpp"
#include "fccda/respond/respond.hpp"
#include "fccda/rigid_body/applied_load.hpp"
#include "fccda/rigid_body/prescribed_motion.hpp"
#include "fccda/rigid_body/rigid_body.hpp"
#include "marine/still_water.hpp"
#include "mesh/surface.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/impactor/contact_bounds_of.hpp"
#include "perimpact/impactor/contact_ledger.hpp"
#include "perimpact/impactor/contact_particles.hpp"
#include "perimpact/impactor/deforming_part.hpp"
#include "perimpact/impactor/gauges_of.hpp"
#include "perimpact/impactor/remeshed.hpp"
#include "perimpact/impactor/surface_of.hpp"
#include "perimpact/particles/shared_numbers.hpp"

namespace perimpact {

/// Cumulative ledger of contact and water; means over intervals are differences.
struct Account {
  Vec3d impulse{};           ///< [N s]
  Vec3d angular_impulse{};   ///< [N m s] about the centre of mass
  std::size_t contacts = 0;  ///< particles in contact in the last step

  double water_impulse = 0;       ///< [N s] of weight, buoyancy and damping, upward
  Vec3d water_angular_impulse{};  ///< [N m s] of these about the centre of mass
};

/// Contact impulse of a particle on an impactor.
struct ContactImpulse {
  std::size_t body;                 ///< index
  fccda::Contact contact;           ///< of the particle in this slot, on the lattice of the whole body
  Vec3d impulse;                    ///< [N s] on the impactor
  std::optional<std::size_t> slot;  ///< of the particle; empty if another rank owns it
};

/// A particle in a slot of the lattice of its whole body.
struct ParticleOfBody {
  std::size_t body;  ///< index
  std::size_t slot;
};

/// Contact on an impactor in the last step.
struct LastStep {
  Vec3d impulse{};                               ///< [N s]
  Vec3d angular_impulse{};                       ///< [N m s] about the centre of mass
  std::vector<ContactImpulse> contact_impulses;  ///< of all ranks, by body; a particle pushed back by other impactors may occur more than once
  std::vector<ParticleOfBody> crushed;           ///< particles that it has completely crushed (CrushedMaterial), of all ranks
};

/// Hydrostatics of an impactor at t = 0.
struct PlacedInWater {
  fccda::Hydrostatics hydrostatics;
  double draft;                ///< [m] draft of its lowest point; negative above water
  std::optional<double> rise;  ///< [m] to equilibrium in this attitude; empty if it sinks
};

/// Particles of a body for which no position outside all impactors was found.
struct UnresolvedPenetration {
  std::uint64_t count = 0;  ///< summed over steps
  double first = 0;         ///< [s] time of the first, if any
};

/// Surface of an impactor, checked and remeshed, before searches and loads are built on it.
struct ImpactorSurface {
  std::size_t crossing_panels = 0;  ///< of the given surface
  Remeshed remeshed;
};

/// Reads or generates the surface. Throws SetupError.
ImpactorSurface surface_of(const ImpactorSetup& setup);

class Impactor {
 public:
  /// Creates one detector per body, in order. Throws SetupError.
  Impactor(const ImpactorSetup& setup, const ImpactorContactSetup& contact, std::span<Particles* const> bodies);
  /// The same with its surface_of().
  Impactor(const ImpactorSetup& setup, const ImpactorContactSetup& contact, std::span<Particles* const> bodies, ImpactorSurface surface);

  /// Gives the impactor vibration modes, on the vertices of its panels. Before the first step. Throws SetupError.
  void make_elastic(fccda::Modes modes);
  /// The same with a surface that another program moves; `masses` [kg] of the vertices.
  void make_external(fccda::StructureSolver solver, std::vector<double> masses);
  const DeformingPart* deforming() const { return deforming_.get(); }  ///< null if it is rigid
  std::vector<Vec3d> vertices() const;                                 ///< [m] current, of its panels, in the world frame

  /// Applies motion tables and loads for the step, and moves the impactor as without contact.
  void advance(const fccda::Step& step);

  /// Detects, relocates, and changes the velocities of particles (contact.md, "Per step"; Zhang et al., eqs. 8–10). Impulses are collected
  /// and applied to the impactor by finish_step(). Returns the contacts, valid until the next call.
  std::span<const fccda::Contact> resolve_contact(std::size_t body, ContactParticles& particles);

  /// The same for particles, ascending, that other impactors displaced after resolve_contact() in this step.
  std::span<const fccda::Contact> resolve_contact_again(std::size_t body, ContactParticles& particles, std::span<const std::size_t> which);

  /// Those particles that are inside the surface at the end of the step, or nearer to it than the contact radius.
  std::vector<std::size_t> still_inside(std::size_t body, const ContactParticles& particles, std::span<const std::size_t> which);

  /// After a pass over all bodies: collects its contacts, in the order of body and slot, from all ranks. Collective.
  void collect_contacts(Ranks& ranks);

  /// True if the impactor's motion is consistent with the impulses of this pass within tolerance. Always true for constrained impactors, and
  /// for the detector `published`, which applies the impulse after the step as in the FCCDA paper.
  bool moved_with_contact();

  /// Begins another pass over all bodies from the initial particle positions; the impactor moves with the impulses of the previous pass.
  /// `last`: of the last pass; if the passes have not converged, the impactor moves again as in the best of them.
  void repeat_step(bool last);

  /// After the last pass: applies the impulse to the impactor and updates the ledgers.
  void finish_step();

  /// Records particles of the body that remain inside at `time` [s], between this impactor and others.
  void record_unresolved(std::size_t body, std::size_t particles, double time);

  /// Notifies that another impactor displaced this particle.
  void moved(std::size_t body, std::size_t particle);

  /// After finish_step(): the particle was relocated to its prescribed position.
  void put_back(std::size_t body, std::size_t particle);

  /// Discards cached distances to the particles of that body, which were renumbered.
  void forget_distances(std::size_t body);

  const std::string& name() const { return name_; }
  const fccda::RigidBody& body() const { return *body_; }
  const fccda::Surface& surface() const { return *surface_; }
  std::size_t crossing_panels() const { return crossing_panels_; }  ///< intersecting panels within one body of the given surface
  const fccda::SurfaceReport& report_as_given() const { return remeshing_ ? remeshing_->given : surface_->report(); }  ///< before remeshing
  const std::optional<Remeshing>& remeshing() const { return remeshing_; }                                             ///< of the surface, if any
  const ImpactorBounds& region() const { return region_; }
  const fccda::Published* published(std::size_t body) const { return std::get_if<fccda::Published>(&detectors_[body]); }
  /// False if contacts have no panels, with the analytic detector.
  bool names_panels() const { return detectors_.empty() || !std::holds_alternative<fccda::Analytic>(detectors_.front()); }
  fccda::Effort effort(std::size_t body) const;  ///< cumulative, of detection against that body

  /// Slots of that body whose particles are inside the surface, or nearer to it than the contact radius (exclusive).
  std::vector<std::size_t> initial_overlap(std::size_t body, const ContactParticles& particles) const;

  /// Nearest positions outside the surface for particles of that body; empty if there is none.
  std::vector<std::optional<Vec3d>> nearest_outside(std::size_t body, std::span<const Vec3d> places) const;

  std::size_t buried_triangles() const;  ///< triangles that may lie inside another closed part of the surface; 0 if the detector does not need them
  const UnresolvedPenetration& unresolved(std::size_t body) const { return unresolved_[body]; }

  /// Number of particles that penetrated where the contact bounds clip the surface, without contact.
  std::uint64_t entered_inside(std::size_t body) const;

  const Account& account() const { return account_; }
  const LastStep& last_step() const { return last_step_; }  ///< empty before the first step, and after a restart
  /// Contact impulses of particles of this rank in the last step, without those relocated to a prescribed position; empty if the impulse is applied after
  /// the step.
  std::vector<ContactImpulse> contact_impulses_now() const;
  /// [J] at the end of the last step, with vibration, assuming constant contact forces, since the velocity is that of mid-step.
  double kinetic_energy() const;
  double kinetic_energy_of_scheme() const;                        ///< [J] with the velocity of mid-step
  std::span<const NamedGauge> gauges() const { return gauges_; }  ///< with cumulative sums

  /// Largest known velocity: per degree of freedom the current one or the maximum of its table.
  Vec3d fastest_velocity() const;          ///< [m/s] of the centre of mass
  Vec3d fastest_angular_velocity() const;  ///< [rad/s]

  /// False if a table, a load or water changes the velocity without contact.
  bool coasts() const { return prescribed_.is_empty() && loads_.empty() && !water_; }
  /// Cumulative: steps in which its motion and its impulses did not agree within a tenth after all passes.
  std::int64_t unconverged_steps() const { return unconverged_steps_; }
  double constraint_work() const { return body_->constraint_work(); }    ///< [J] cumulative, of constraints and prescribed motion
  double load_work() const { return load_work_; }                        ///< [J] cumulative, of applied loads
  double contact_work() const { return contact_work_; }                  ///< [J] cumulative, on the impactor by contact
  bool crushes() const { return crushes_; }                              ///< the material of particles in contact
  double crushing_dissipation() const { return crushing_dissipation_; }  ///< [J] cumulative, force times depth of what is crushed; part of that of contact
  double work_on_particles() const { return work_on_particles_; }        ///< [J] cumulative, on particles in contact (docs/theory/energy.md)
  double water_work() const { return water_work_; }                      ///< [J] cumulative, of weight, buoyancy and their damping

  const std::optional<fccda::StillWater>& water() const { return water_; }
  fccda::Hydrostatics hydrostatics() const { return fccda::hydrostatics(*body_, *surface_, *water_); }  ///< current; requires water
  double draft() const { return water_->level - keel(*body_, *surface_); }                              ///< [m] current; requires water; negative above water
  const std::optional<PlacedInWater>& placed_in_water() const { return placed_in_water_; }

  const ContactRecord& record() const { return record_; }
  /// Closes the interval of the process curve, which is that of the history.
  void end_history_interval(double time, double duration) { record_.end_interval(time, duration); }
  /// Closes the interval over which loads of panels are averaged.
  void end_load_interval(double time, double duration) { record_.end_load_interval(time, duration); }

  /// See base/state.hpp.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    auto its = fccda::under(name_, visit);
    body_->visit_state(its);
    if (deforming_) deforming_->visit_state(its);
    its("load_work", load_work_);
    if (water_) its("work_of_water", water_work_);
    for (std::size_t b = 0; b < detectors_.size(); ++b) {
      auto of_body = fccda::under(std::to_string(b), its);
      std::visit([&](auto& detector) { detector.visit_state(of_detector(b, of_body)); }, detectors_[b]);
      of_body("unresolved_penetrations", unresolved_[b].count);
      of_body("first_unresolved_penetration", unresolved_[b].first);
    }
  }

  /// Record, which does not affect steps.
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    auto its = fccda::under(name_, visit);
    for (std::size_t b = 0; b < detectors_.size(); ++b) {
      const auto of_body = fccda::under(std::to_string(b), its);
      std::visit([&](auto& detector) { detector.visit_record(of_counts(of_body)); }, detectors_[b]);
    }
    if (deforming_) deforming_->visit_record(its);
    auto account = fccda::under("account", its);
    fccda::visit_vector(account, "impulse", account_.impulse);
    fccda::visit_vector(account, "angular_impulse", account_.angular_impulse);
    account("contacts", account_.contacts);
    account("work_of_contact", contact_work_);
    account("unconverged_steps", unconverged_steps_);
    account("work_on_particles", work_on_particles_);
    if (crushes_) account("crushing_dissipation", crushing_dissipation_);
    if (water_) {
      account("water_impulse", account_.water_impulse);
      fccda::visit_vector(account, "water_angular_impulse", account_.water_angular_impulse);
    }
    auto gauges = fccda::under("gauges", its);
    for (NamedGauge& named : gauges_) named.gauge.visit_state(fccda::under(named.name, gauges));
    record_.visit_state(fccda::under("record", its));
  }

 private:
  void float_in_water(const fccda::Step& step);
  /// Contact impulse of this pass, which a further pass may replace.
  struct Pending {
    ContactImpulse contact_impulse;
    Vec3d place;              // [m] where it acts
    double work_on_particle;  // [J]
    double mass;              // [kg] of the particle
    double rigidity = 1;      // of its contact (Coupling::add)
    double crushing = 0;      // [J] dissipated
    bool is_crushed = false;  // the particle, after this contact
  };
  /// What the structure of a deforming surface receives of such a contact; its particle is numbered on the lattice of the whole body.
  struct PendingOnPanel {
    std::size_t body;
    fccda::DeformingContact contact;
    fccda::PanelImpulse impulse;
    double mass;  // [kg] of the particle
  };

  void add_crushing(const ContactParticles& particles, std::size_t slot, Pending& pending) const;
  std::span<const fccda::Contact> respond_to_contacts(std::size_t body, ContactParticles& particles);
  std::span<const fccda::Contact> respond_to_deforming_contacts(std::size_t body, ContactParticles& particles);
  void collect_panel_contacts(Ranks& ranks);
  fccda::Impulse sum_of_pending() const;
  void expect_deformable() const;
  template <class Make>
  void deform(const Make& make);
  std::vector<double> contact_radii() const;
  void count_in_contact();
  std::string name_;
  std::size_t crossing_panels_;
  std::optional<Remeshing> remeshing_;
  std::shared_ptr<const fccda::Surface> surface_;
  ImpactorBounds region_;
  fccda::PrescribedMotion prescribed_;
  std::vector<fccda::AppliedLoad> loads_;
  std::unique_ptr<fccda::RigidBody> body_;    // an address that its structure may keep
  std::unique_ptr<DeformingPart> deforming_;  // if its surface deforms
  double radius_;                             // [m] of all vertices about the centre of mass
  double friction_;
  bool crushes_;                            // the material of particles in contact
  std::vector<fccda::Detector> detectors_;  // one per body, for the surface as long as it is not deformed
  fccda::Motion motion_;
  std::vector<fccda::Contact> contacts_;           // of the latest detection
  std::vector<UnresolvedPenetration> unresolved_;  // by body
  fccda::Coupling coupling_;                       // of the step in progress
  bool is_coupled_;
  bool is_first_pass_ = true;
  std::vector<Pending> pending_;                               // of this pass
  std::vector<PendingOnPanel> pending_on_panels_;              // of this pass and rank, if the surface deforms
  std::vector<std::pair<std::size_t, std::size_t>> put_back_;  // body and particle, in the last step
  Account account_;
  LastStep last_step_;
  std::vector<NamedGauge> gauges_;
  std::optional<fccda::StillWater> water_;
  std::optional<PlacedInWater> placed_in_water_;
  double load_work_ = 0, water_work_ = 0;                                       // [J]
  double contact_work_ = 0, work_on_particles_ = 0, crushing_dissipation_ = 0;  // [J]
  std::int64_t unconverged_steps_ = 0;
  ContactRecord record_;
};

}  // namespace perimpact
