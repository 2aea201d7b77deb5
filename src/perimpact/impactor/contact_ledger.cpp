#include "perimpact/impactor/contact_ledger.hpp"

#include <algorithm>

namespace perimpact {

ContactRecord::ContactRecord(const fccda::Surface& surface, std::span<const double> faces) : panels_(surface, faces) {
  for (const double face : faces) in_contact_.push_back({.face = face});
}

bool ContactRecord::was_in_contact() const {
  return std::any_of(in_contact_.begin(), in_contact_.end(), [](const Resolved& body) { return body.ever; });
}

void ContactRecord::add(std::size_t body, const fccda::Contact& contact, const fccda::Vec3d& impulse) {
  panels_.add(body, contact, impulse);
  const double normal = -dot(impulse, contact.normal);
  normal_impulse_ += normal, load_impulse_ += normal;
  Resolved& resolved = in_contact_[body];
  resolved.ever = true;
  const auto at = std::ranges::lower_bound(resolved.particles, contact.point);
  if (at == resolved.particles.end() || *at != contact.point) resolved.particles.insert(at, contact.point);
}

void ContactRecord::end_interval(double time, double duration) {
  interval_ = {.time = time, .normal_force = duration > 0 ? normal_impulse_ / duration : 0};
  for (Resolved& body : in_contact_) {
    interval_.contact_area += static_cast<double>(body.particles.size()) * body.face;
    if (steps_ > 0) interval_.mean_contact_area += static_cast<double>(body.contacts) * body.face / static_cast<double>(steps_);
    body.contacts = 0;
    body.particles.clear();
  }
  steps_ = 0;
  normal_impulse_ = 0;
}

void ContactRecord::end_load_interval(double time, double duration) {
  panels_.end_interval(duration);
  if (const double force = load_impulse_ / duration; force > peak_.normal_force) {
    const auto pressure = panels_.interval_pressure();
    peak_ = {time, force, {pressure.begin(), pressure.end()}};
  }
  load_impulse_ = 0;
}

}  // namespace perimpact
