#include "perimpact/impact/impactor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "perimpact/impact/surface_of.hpp"
#include "perimpact/setup/setup_error.hpp"

namespace perimpact {

using namespace fccda;

namespace {

RigidBodyProperties properties_of(const ImpactorSetup& setup, const Surface& surface) {
  const SurfaceReport& report = surface.report();
  RigidBodyProperties properties{.mass = setup.mass, .centre_of_mass = report.centroid};
  if (setup.inertia) {
    properties.inertia = Mat3::diagonal(*setup.inertia);
  } else if (surface.is_closed() && report.volume > 0) {
    const double density = setup.mass / report.volume;
    const Vec3d d = density * report.inertia_diagonal, p = density * report.inertia_products;
    properties.inertia = {{{d.x, -p.z, -p.y}, {-p.z, d.y, -p.x}, {-p.y, -p.x, d.z}}};
  }
  return properties;
}

FreeDegrees degrees_of(const ImpactorSetup& setup) {
  constexpr std::string_view names[] = {"x", "y", "z", "rx", "ry", "rz"};
  FreeDegrees degrees;
  for (const std::string& word : setup.free)
    for (std::size_t d = 0; d < 6; ++d)
      if (word == names[d]) degrees.free[d] = true;
  return degrees;
}

Region make_region(const ImpactorSetup& setup, const Surface& surface) {
  const auto* box = std::get_if<BoxRegionSetup>(&setup.region.shape);
  if (!box) return Unbounded();
  try {
    return BoxRegion({box->size, box->centre}, surface, setup.region.outside.as<Beyond>());
  } catch (const InputError& error) {
    throw SetupError("impactors." + setup.name + ".region", error.what());
  }
}

AnalyticShape shape_of(const ImpactorSetup& setup) {
  if (const auto* sphere = std::get_if<SphereSurface>(&setup.surface)) return Sphere{.radius = sphere->diameter / 2};
  const auto* cylinder = std::get_if<CylinderSurface>(&setup.surface);
  if (!cylinder)
    throw SetupError("impactors." + setup.name + ".surface",
                     "the analytic detector knows cylinders and spheres only; take the detector swept for any other surface.");
  Vec3d axis{};
  axis[static_cast<std::size_t>(cylinder->axis.index)] = 1;
  return InfiniteCylinder{.radius = cylinder->diameter / 2, .axis = axis};
}

Detector make_detector(const ImpactorSetup& setup, const ImpactorContactSetup& contact, std::shared_ptr<const Surface> surface, double spacing) {
  const Region region = make_region(setup, *surface);
  const double radius = contact.radius_ratio * spacing;
  switch (contact.detector.as<DetectorKind>()) {
    case DetectorKind::analytic:
      return Analytic(shape_of(setup), region, radius);
    case DetectorKind::published:
      return Published(std::move(surface), region, contact.reading.as<Published::Reading>());
    case DetectorKind::swept:
      break;
  }
  return Swept(std::move(surface), region, radius);
}

RigidBody make_body(const ImpactorSetup& setup, const Surface& surface) {
  try {
    return RigidBody(properties_of(setup, surface), Pose(setup.position), setup.velocity, setup.angular_velocity, degrees_of(setup));
  } catch (const InputError& error) {
    throw SetupError("impactors." + setup.name, fmt::format("impactor {}: {}", setup.name, error.what()));
  }
}

}  // namespace

Impactor::Impactor(const ImpactorSetup& setup, const ImpactorContactSetup& contact, std::span<Particles* const> bodies)
    : name_(setup.name),
      surface_(std::make_shared<const Surface>(surface_of(setup.surface, setup.name))),
      body_(make_body(setup, *surface_)),
      radius_(surface_->radius_about(body_.properties().centre_of_mass)),
      friction_(contact.friction),
      pinched_(bodies.size()) {
  for (const Particles* particles : bodies) detectors_.push_back(make_detector(setup, contact, surface_, particles->lattice().spacing));
}

std::size_t Impactor::particles_inside(std::size_t body, const StruckParticles& particles) const {
  return std::visit([&](const auto& detector) { return detector.starting_inside(particles, body_.pose()).size(); }, detectors_[body]);
}

std::uint64_t Impactor::entered_inside(std::size_t body) const {
  const auto* swept = std::get_if<Swept>(&detectors_[body]);
  return swept ? swept->entered_inside() : 0;
}

std::size_t Impactor::buried_triangles() const {
  const auto* swept = detectors_.empty() ? nullptr : std::get_if<Swept>(&detectors_.front());
  return swept ? swept->buried_triangles() : 0;
}

fccda::Effort Impactor::effort(std::size_t body) const {
  return std::visit([](const auto& detector) { return detector.effort(); }, detectors_[body]);
}

void Impactor::advance(double dt) {
  motion_ = body_.advance(dt);
  account_.contacts = 0;
}

std::span<const Contact> Impactor::strike(std::size_t body, StruckParticles& particles) {
  contacts_.clear();
  const double travel = body_.travel_bound(motion_, radius_);
  std::visit([&](auto& detector) { detector.detect(particles, motion_, travel, contacts_); }, detectors_[body]);
  struck_.clear();
  return respond_to_contacts(particles);
}

std::span<const Contact> Impactor::strike_again(std::size_t body, StruckParticles& particles, std::span<const std::size_t> which) {
  contacts_.clear();
  const double travel = body_.travel_bound(motion_, radius_);
  std::visit([&](auto& detector) { detector.detect_again(particles, motion_, travel, which, contacts_); }, detectors_[body]);
  return respond_to_contacts(particles);
}

std::span<const Contact> Impactor::respond_to_contacts(StruckParticles& particles) {
  const Tally tally = respond(particles, contacts_, motion_, body_, friction_);
  account_.impulse += tally.impulse;
  account_.angular_impulse += tally.angular_impulse_about_com;
  account_.contacts += add_struck();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!body_.degrees().translation(axis)) work_ -= tally.impulse[axis] * body_.velocity()[axis];
    if (!body_.degrees().rotation(axis)) work_ -= tally.angular_impulse_about_com[axis] * body_.angular_velocity()[axis];
  }
  return contacts_;
}

// Counts particles, not passes.
std::size_t Impactor::add_struck() {
  std::vector<std::size_t> points, all;
  for (const Contact& contact : contacts_) points.push_back(contact.point);
  std::set_union(struck_.begin(), struck_.end(), points.begin(), points.end(), std::back_inserter(all));
  const std::size_t fresh = all.size() - struck_.size();
  struck_ = std::move(all);
  return fresh;
}

std::vector<std::size_t> Impactor::still_inside(std::size_t body, const StruckParticles& particles, std::span<const std::size_t> which) {
  return std::visit([&](auto& detector) { return detector.still_inside(particles, motion_, which); }, detectors_[body]);
}

void Impactor::note_pinched(std::size_t body, std::size_t particles, double time) {
  if (particles > 0 && pinched_[body].count == 0) pinched_[body].first = time;
  pinched_[body].count += particles;
}

void Impactor::moved(std::size_t body, std::size_t particle) {
  std::visit([&](auto& detector) { detector.moved(particle); }, detectors_[body]);
}

}  // namespace perimpact
