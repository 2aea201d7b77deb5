#include "perimpact/impactor/impactor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/impactor/modes_of.hpp"
#include "perimpact/impactor/rigid_body_of.hpp"
#include "perimpact/impactor/surface_of.hpp"

namespace perimpact {

using namespace fccda;

namespace {

AnalyticShape shape_of(const ImpactorSetup& setup) {
  if (const auto* sphere = std::get_if<SphereSurface>(&setup.surface)) return Sphere{.radius = sphere->diameter / 2};
  const auto* cylinder = std::get_if<CylinderSurface>(&setup.surface);
  if (!cylinder)
    throw SetupError("impactors." + setup.name + ".surface",
                     "the analytic detector supports cylinders and spheres only; use detector: swept for any other surface.");
  Vec3d axis{};
  axis[static_cast<std::size_t>(cylinder->axis.index)] = 1;
  return InfiniteCylinder{.radius = cylinder->diameter / 2, .axis = axis};
}

/// `shared`: search structure of this impactor's detectors, built by the first that needs it.
Detector make_detector(const ImpactorSetup& setup, const ImpactorContactSetup& contact, const std::shared_ptr<const Surface>& surface, SharedSurface& shared,
                       const ContactBounds& region, double spacing) {
  const double radius = contact.radius_ratio * spacing;
  switch (contact.detector.as<DetectorKind>()) {
    case DetectorKind::analytic:
      return Analytic(shape_of(setup), region, radius);
    case DetectorKind::published:
      return Published(surface, region, contact.variant.as<Published::Variant, variant_words>());
    case DetectorKind::swept:
      break;
  }
  if (!shared) shared = share(surface);
  return Swept(shared, region, radius);
}

/// During a run, an impulse or rotation out of range is a RunError, not an error of the deck.
template <class Act>
auto in_run(const std::string& impactor, const Act& act) {
  try {
    return act();
  } catch (const InputError& error) {
    throw RunError(fmt::format("impactors.{}: {} The run has become unstable; use a smaller time.step.", impactor, error.what()));
  }
}

std::optional<PlacedInWater> how_placed(const std::optional<StillWater>& water, const RigidBody& body, const Surface& surface) {
  if (!water) return std::nullopt;
  PlacedInWater placed{hydrostatics(body, surface, *water), water->level - keel(body, surface), std::nullopt};
  if (const std::optional<double> level = level_at_rest(body, surface, *water)) placed.rise = water->level - *level;
  return placed;
}

std::vector<double> faces_of(std::span<Particles* const> bodies) {
  std::vector<double> faces;
  for (const Particles* particles : bodies) faces.push_back(particles->spacing() * particles->thickness().value_or(particles->spacing()));
  return faces;
}

}  // namespace

ImpactorSurface surface_of(const ImpactorSetup& setup) {
  GivenSurface given = surface_of(setup.surface, setup.name);
  return {given.crossing_panels, remeshed(std::move(given.surface), setup)};
}

Impactor::Impactor(const ImpactorSetup& setup, const ImpactorContactSetup& contact, std::span<Particles* const> bodies)
    : Impactor(setup, contact, bodies, surface_of(setup)) {}

Impactor::Impactor(const ImpactorSetup& setup, const ImpactorContactSetup& contact, std::span<Particles* const> bodies, ImpactorSurface surface)
    : name_(setup.name),
      crossing_panels_(surface.crossing_panels),
      remeshing_(std::move(surface.remeshed.remeshing)),
      surface_(std::make_shared<const Surface>(std::move(surface.remeshed.surface))),
      region_(contact_bounds_of(setup.contact_bounds, *surface_, setup.name)),
      prescribed_(motion_of(setup)),
      loads_(loads_of(setup)),
      body_(std::make_unique<RigidBody>(rigid_body_of(setup, *surface_, prescribed_))),
      radius_(surface_->radius_about(body_->properties().centre_of_mass)),
      friction_(contact.friction),
      crushes_(contact.crushing_pressure.has_value()),
      unresolved_(bodies.size()),
      coupling_(*body_),
      is_coupled_(contact.detector.as<DetectorKind>() != DetectorKind::published),
      gauges_(gauges_of(setup, *surface_, *body_)),
      water_(water_of(setup)),
      placed_in_water_(how_placed(water_, *body_, *surface_)),
      record_(*surface_, faces_of(bodies)) {
  if (crushes_ && !surface_->is_closed())
    throw SetupError("contact.impactors.crushing_pressure",
                     fmt::format("impactor {} has an open surface, which excludes crushing_pressure; close it, or remove crushing_pressure.", name_));
  SharedSurface shared;
  for (const Particles* particles : bodies) detectors_.push_back(make_detector(setup, contact, surface_, shared, region_.region, particles->spacing()));
  if (setup.elastic) make_elastic(modes_of(setup, *surface_));
}

std::vector<std::size_t> Impactor::initial_overlap(std::size_t body, const ContactParticles& particles) const {
  return std::visit([&](const auto& detector) { return detector.initial_overlap(particles, body_->pose()); }, detectors_[body]);
}

std::vector<std::optional<Vec3d>> Impactor::nearest_outside(std::size_t body, std::span<const Vec3d> places) const {
  return std::visit([&](const auto& detector) { return detector.nearest_outside(places, body_->pose()); }, detectors_[body]);
}

void Impactor::forget_distances(std::size_t body) {
  std::visit([](auto& detector) { detector.forget(); }, detectors_[body]);
  if (deforming_) deforming_->detector(body).forget();
}

std::uint64_t Impactor::entered_inside(std::size_t body) const {
  if (deforming_) return deforming_->detector(body).entered_inside();
  const auto* swept = std::get_if<Swept>(&detectors_[body]);
  return swept ? swept->entered_inside() : 0;
}

std::size_t Impactor::buried_triangles() const {
  const auto* swept = detectors_.empty() ? nullptr : std::get_if<Swept>(&detectors_.front());
  return swept ? swept->buried_triangles() : 0;
}

fccda::Effort Impactor::effort(std::size_t body) const {
  if (deforming_) return deforming_->detector(body).effort();
  return std::visit([](const auto& detector) { return detector.effort(); }, detectors_[body]);
}

void Impactor::advance(const Step& step) {
  prescribed_.impose(*body_, step);
  if (water_) float_in_water(step);  // before the loads: otherwise damping would reduce their impulse, and shift the equilibrium by c Δt
  load_work_ += apply(loads_, *body_, step);
  coupling_ = Coupling(*body_);
  const Pose before = body_->pose();
  if (deforming_) in_run(name_, [&] { deforming_->iteration().advance(step); });
  if (deforming_ && deforming_->elastic())
    motion_ = {before, body_->pose(), step.dt, body_->properties().centre_of_mass};
  else
    motion_ = in_run(name_, [&] { return coupling_.advance(*body_, step.dt); });
  is_first_pass_ = true;
  pending_.clear();
  pending_on_panels_.clear();
  put_back_.clear();
  account_.contacts = 0;
  last_step_.impulse = last_step_.angular_impulse = {};
  last_step_.contact_impulses.clear();
  last_step_.crushed.clear();
  record_.begin_step();
}

void Impactor::float_in_water(const Step& step) {
  const WaterSum sum = apply(*water_, *surface_, *body_, step);
  account_.water_impulse += sum.impulse;
  account_.water_angular_impulse += sum.angular_impulse;
  water_work_ += sum.work;
}

Vec3d Impactor::fastest_velocity() const {
  Vec3d velocity = body_->velocity();
  for (std::size_t axis = 0; axis < 3; ++axis) velocity[axis] = prescribed_.largest_velocity(axis, velocity[axis]);
  return velocity;
}

Vec3d Impactor::fastest_angular_velocity() const {
  Vec3d spin = body_->angular_velocity();
  for (std::size_t axis = 0; axis < 3; ++axis) spin[axis] = prescribed_.largest_velocity(3 + axis, spin[axis]);
  return spin;
}

std::span<const Contact> Impactor::resolve_contact(std::size_t body, ContactParticles& particles) {
  contacts_.clear();
  if (deforming_) {
    Deforming& detector = deforming_->detector(body);
    deforming_->contacts().clear();
    if (is_first_pass_)
      detector.detect(particles, deforming_->contacts());
    else
      detector.redetect(particles, deforming_->iteration().correction(), deforming_->contacts());
    return respond_to_deforming_contacts(body, particles);
  }
  const double travel = body_->travel_bound(motion_, radius_);
  std::visit(
      [&](auto& detector) {
        if (is_first_pass_)
          detector.detect(particles, motion_, travel, contacts_);
        else
          detector.redetect(particles, motion_, travel, coupling_.correction(), contacts_);
      },
      detectors_[body]);
  return in_run(name_, [&] { return respond_to_contacts(body, particles); });
}

std::span<const Contact> Impactor::resolve_contact_again(std::size_t body, ContactParticles& particles, std::span<const std::size_t> which) {
  contacts_.clear();
  if (deforming_) {
    deforming_->contacts().clear();
    deforming_->detector(body).detect_again(particles, which, deforming_->contacts());
    return respond_to_deforming_contacts(body, particles);
  }
  const double travel = body_->travel_bound(motion_, radius_);
  std::visit([&](auto& detector) { detector.detect_again(particles, motion_, travel, which, contacts_); }, detectors_[body]);
  return in_run(name_, [&] { return respond_to_contacts(body, particles); });
}

std::span<const Contact> Impactor::respond_to_contacts(std::size_t body, ContactParticles& particles) {
  resolve_points(particles, contacts_, motion_, body_->position_of_com(), friction_, [&](const Contact& contact, const Vec3d& impulse) {
    const Vec3d place = point_of_application(contact, particles.centre_t0(contact.point), particles.centre_t1(contact.point), motion_);
    const std::size_t slot = contact.point;
    ContactImpulse contact_impulse{body, contact, impulse, slot};
    contact_impulse.contact.point = particles.whole_slot(slot);
    pending_.push_back({contact_impulse, place, particles.work_of(slot, -impulse), particles.mass(slot)});
    if (crushes_) add_crushing(particles, slot, pending_.back());
  });
  return contacts_;
}

/// After the response: the radius is shorter by half of the depth.
void Impactor::add_crushing(const ContactParticles& particles, std::size_t slot, Pending& pending) const {
  const Contact& contact = pending.contact_impulse.contact;
  const double depth = 2 * (contact.radius - particles.radius(slot));
  if (!(depth > 0)) return;
  const fccda::Crushing material = particles.crushing(slot);
  pending.crushing = material.force(material.depth) * depth;
  pending.is_crushed = particles.is_crushed(slot);
  if (!pending.is_crushed) pending.rigidity = material.rigidity(pending.mass, motion_.dt);  // else contact has become rigid within the step
}

std::span<const Contact> Impactor::respond_to_deforming_contacts(std::size_t body, ContactParticles& particles) {
  for (const DeformingContact& deforming : deforming_->contacts()) {
    const Contact& contact = deforming.contact;
    const std::size_t i = contact.point;
    const double mass = particles.mass(i);
    const PanelImpulse after = resolved(deforming, particles.position_t0(i), particles.velocity(i), mass, motion_.dt, friction_);
    particles.set(i, after.point.position, after.point.velocity);
    ContactImpulse contact_impulse{body, contact, after.on_surface, i};
    contact_impulse.contact.point = particles.whole_slot(i);
    pending_.push_back({contact_impulse, after.point.position, particles.work_of(i, -after.on_surface), mass});
    pending_on_panels_.push_back({body, {contact_impulse.contact, deforming.place}, after, mass});
    contacts_.push_back(contact);
  }
  return contacts_;
}

void Impactor::collect_contacts(Ranks& ranks) {
  if (ranks.size() > 1) {
    static_assert(std::is_trivially_copyable_v<Pending>);
    const std::vector<Ranks::Bytes> all = ranks.gather_all(std::as_bytes(std::span(pending_)));
    pending_.clear();
    for (std::size_t rank = 0; rank < all.size(); ++rank)
      for (std::size_t at = 0; at < all[rank].size(); at += sizeof(Pending)) {
        Pending& pending = pending_.emplace_back();
        std::memcpy(&pending, all[rank].data() + at, sizeof(Pending));
        pending.contact_impulse.contact.sliding = nullptr;
        if (static_cast<int>(rank) != ranks.rank()) pending.contact_impulse.slot.reset();
      }
  }
  const auto body_and_slot = [](const Pending& one) { return std::pair(one.contact_impulse.body, one.contact_impulse.contact.point); };
  std::ranges::stable_sort(pending_, {}, body_and_slot);
  if (deforming_) return collect_panel_contacts(ranks);
  for (const Pending& one : pending_) coupling_.add(one.contact_impulse.contact, one.mass, one.place, one.contact_impulse.impulse, friction_, one.rigidity);
}

void Impactor::collect_panel_contacts(Ranks& ranks) {
  static_assert(std::is_trivially_copyable_v<PendingOnPanel>);
  std::vector<PendingOnPanel> all = ranks.join_all(std::span<const PendingOnPanel>(pending_on_panels_));
  const auto body_and_slot = [](const PendingOnPanel& one) { return std::pair(one.body, one.contact.contact.point); };
  std::ranges::stable_sort(all, {}, body_and_slot);
  for (const PendingOnPanel& one : all) deforming_->iteration().add(one.contact, one.mass, one.impulse, friction_);
}

bool Impactor::moved_with_contact() {
  if (deforming_) return deforming_->iteration().agrees();
  return !is_coupled_ || coupling_.agrees(radius_);
}

void Impactor::repeat_step(bool last) {
  constexpr double near = 0.1;
  is_first_pass_ = false;
  pending_.clear();
  pending_on_panels_.clear();
  if (deforming_) {
    StructureCoupling& iteration = deforming_->iteration();
    const bool leads_nowhere = last && !iteration.agrees(near);
    if (leads_nowhere) ++unconverged_steps_;
    in_run(name_, [&] { leads_nowhere ? iteration.retreat() : iteration.correct(); });
    if (deforming_->elastic()) motion_.t1 = body_->pose();
    return;
  }
  const bool leads_nowhere = last && !coupling_.agrees(radius_, near);
  if (leads_nowhere) ++unconverged_steps_;
  motion_ = in_run(name_, [&] { return leads_nowhere ? coupling_.retreat(*body_, radius_) : coupling_.correct(*body_, radius_); });
}

void Impactor::finish_step() {
  for (const Pending& pending : pending_) {
    for (NamedGauge& named : gauges_) named.gauge.add(pending.contact_impulse.contact, pending.place, pending.contact_impulse.impulse, motion_);
    record_.add(pending.contact_impulse.body, pending.contact_impulse.contact, pending.contact_impulse.impulse);
    work_on_particles_ += pending.work_on_particle;
    crushing_dissipation_ += pending.crushing;
    if (pending.is_crushed) last_step_.crushed.push_back({pending.contact_impulse.body, pending.contact_impulse.contact.point});
    last_step_.contact_impulses.push_back(pending.contact_impulse);
  }
  count_in_contact();
  const Impulse found = deforming_ ? sum_of_pending() : coupling_.found();
  contact_work_ += in_run(name_, [&] { return deforming_ ? deforming_->iteration().finish() : coupling_.finish(*body_); });
  last_step_.impulse = found.linear;
  last_step_.angular_impulse = found.angular;
  account_.impulse += last_step_.impulse;
  account_.angular_impulse += last_step_.angular_impulse;
}

Impulse Impactor::sum_of_pending() const {
  Impulse sum;
  for (const Pending& pending : pending_) {
    const Vec3d& impulse = pending.contact_impulse.impulse;
    sum.linear += impulse;
    sum.angular += cross(pending.place - body_->position_of_com(), impulse);
  }
  return sum;
}

// Counts particles, not impulses: several impactors may act on one within a step.
void Impactor::count_in_contact() {
  std::vector<std::size_t> points;
  for (auto contact_impulse = pending_.begin(); contact_impulse != pending_.end();) {
    const std::size_t body = contact_impulse->contact_impulse.body;
    points.clear();
    for (; contact_impulse != pending_.end() && contact_impulse->contact_impulse.body == body; ++contact_impulse)
      points.push_back(contact_impulse->contact_impulse.contact.point);
    std::sort(points.begin(), points.end());
    const auto resolved = static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
    account_.contacts += resolved;
    record_.count_in_contact(body, resolved);
  }
}

std::vector<std::size_t> Impactor::still_inside(std::size_t body, const ContactParticles& particles, std::span<const std::size_t> which) {
  if (deforming_) return deforming_->detector(body).still_inside(particles, which);
  return std::visit([&](auto& detector) { return detector.still_inside(particles, motion_, which); }, detectors_[body]);
}

void Impactor::record_unresolved(std::size_t body, std::size_t particles, double time) {
  if (particles > 0 && unresolved_[body].count == 0) unresolved_[body].first = time;
  unresolved_[body].count += particles;
}

void Impactor::moved(std::size_t body, std::size_t particle) {
  if (deforming_) return deforming_->detector(body).moved(particle);
  std::visit([&](auto& detector) { detector.moved(particle); }, detectors_[body]);
}

void Impactor::put_back(std::size_t body, std::size_t particle) {
  moved(body, particle);
  put_back_.emplace_back(body, particle);
}

std::vector<ContactImpulse> Impactor::contact_impulses_now() const {
  std::vector<ContactImpulse> contact_impulses;
  if (!is_coupled_) return contact_impulses;
  std::vector<std::pair<std::size_t, std::size_t>> left_out = put_back_;
  std::sort(left_out.begin(), left_out.end());
  for (const ContactImpulse& contact_impulse : last_step_.contact_impulses)
    if (contact_impulse.slot && !std::binary_search(left_out.begin(), left_out.end(), std::pair(contact_impulse.body, *contact_impulse.slot)))
      contact_impulses.push_back(contact_impulse);
  return contact_impulses;
}

double Impactor::kinetic_energy() const {
  RigidBody later = *body_;
  if (is_coupled_) later.add_impulse(0.5 * last_step_.impulse, 0.5 * last_step_.angular_impulse);
  return later.kinetic_energy() + (deforming_ ? deforming_->kinetic_energy() : 0);
}

double Impactor::kinetic_energy_of_scheme() const { return body_->kinetic_energy() + (deforming_ ? deforming_->kinetic_energy_of_scheme() : 0); }

void Impactor::expect_deformable() const {
  const std::string key = "impactors." + name_;
  if (!std::ranges::all_of(detectors_, [](const Detector& detector) { return std::holds_alternative<Swept>(detector); }))
    throw SetupError("contact.impactors.detector", fmt::format("impactor {} deforms, which needs detector: swept.", name_));
  if (remeshing_)
    throw SetupError(key, fmt::format("impactor {} deforms, so that its mesh cannot be coarsened or refined; its vertices carry the modes.", name_));
  if (!std::holds_alternative<Unbounded>(region_.region))
    throw SetupError(key + ".contact_bounds", fmt::format("impactor {} deforms, which excludes contact bounds; remove them.", name_));
  if (crushes_)
    throw SetupError("contact.impactors.crushing_pressure", fmt::format("impactor {} deforms, which excludes crushing_pressure; remove it.", name_));
  if (water_) throw SetupError(key + ".floating", fmt::format("impactor {} deforms, which excludes floating; remove one of them.", name_));
}

std::vector<double> Impactor::contact_radii() const {
  std::vector<double> radii;
  for (const Detector& detector : detectors_) radii.push_back(std::get<Swept>(detector).radius());
  return radii;
}

std::vector<Vec3d> Impactor::vertices() const {
  if (deforming_) return {deforming_->vertices().begin(), deforming_->vertices().end()};
  std::vector<Vec3d> vertices(surface_->panels().vertices);
  for (Vec3d& vertex : vertices) vertex = body_->pose().to_world(vertex);
  return vertices;
}

void Impactor::make_elastic(Modes modes) {
  expect_deformable();
  deform([&] { return std::make_unique<ElasticBody>(*body_, std::move(modes), surface_->panels().vertices); });
}

void Impactor::make_external(StructureSolver solver, std::vector<double> masses) {
  expect_deformable();
  if (!loads_.empty() || !prescribed_.is_empty() || fastest_velocity() != Vec3d{} || fastest_angular_velocity() != Vec3d{})
    throw SetupError("impactors." + name_,
                     fmt::format("the surface of impactor {} is moved by a structure, which excludes velocities, motion and loads.", name_));
  deform([&] { return std::make_unique<ExternalStructure>(std::move(solver), std::move(masses), vertices()); });
}

template <class Make>
void Impactor::deform(const Make& make) {
  try {
    DeformingPart::AnyStructure structure = make();
    deforming_ = std::make_unique<DeformingPart>(std::move(structure), *surface_, vertices(), contact_radii());
  } catch (const InputError& error) {
    throw SetupError("impactors." + name_, fmt::format("impactor {}: {}", name_, error.what()));
  }
}

}  // namespace perimpact
