#include "fccda/elastic/structure_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fccda/respond/impulse_change.hpp"

namespace fccda {

StructureCoupling::StructureCoupling(Structure& structure, DeformingSurface& surface)
    : structure_(structure), surface_(surface), assumed_(structure.size(), 0.0), found_(structure.size(), 0.0), vertices_(structure.vertex_count()) {}

void StructureCoupling::start_at(std::span<const Vec3d> vertices) { vertices_.assign(vertices.begin(), vertices.end()); }

void StructureCoupling::advance(const Step& step) {
  dt_ = step.dt;
  std::fill(assumed_.begin(), assumed_.end(), 0.0);
  std::fill(found_.begin(), found_.end(), 0.0);
  places_.clear(), touched_.clear(), active_.clear();
  best_ = assumed_, least_error_ = std::numeric_limits<double>::infinity();
  structure_.begin(step);
  structure_.move(assumed_, vertices_);
  surface_.move(vertices_);
}

void StructureCoupling::add(const DeformingContact& contact, double mass, const PanelImpulse& impulse, double friction) {
  for (std::size_t k = 0; k < 3; ++k) structure_.add_vertex_impulse(static_cast<std::size_t>(contact.place.vertices[k]), impulse.on_vertices[k], found_);
  const auto [along, sticks] = change_of(contact.contact, impulse.on_surface, friction);
  places_.push_back({contact.place.vertices, contact.place.weights, mass, contact.contact.normal, along, sticks});
}

Vec3d StructureCoupling::velocity_at(const Place& place, std::span<const double> velocity) const {
  Vec3d at{};
  for (std::size_t k = 0; k < 3; ++k) at += place.weights[k] * structure_.vertex_velocity(static_cast<std::size_t>(place.vertices[k]), velocity);
  return at;
}

// [m/s] that the impulse causes at the vertices that were in contact in any pass.
double StructureCoupling::largest_velocity(std::span<const double> impulse) const {
  std::vector<double> velocity(structure_.size(), 0.0);
  structure_.velocity_change(active_, impulse, velocity);
  double largest = 0;
  for (const int vertex : touched_) largest = std::max(largest, norm(structure_.vertex_velocity(static_cast<std::size_t>(vertex), velocity)));
  return largest;
}

// [N s] by which the found impulse exceeds the assumed one.
std::vector<double> StructureCoupling::missing() const {
  std::vector<double> missing(found_);
  for (std::size_t c = 0; c < missing.size(); ++c) missing[c] -= assumed_[c];
  return missing;
}

bool StructureCoupling::agrees(double share) {
  activate();
  if (touched_.empty()) return true;
  const double error = largest_velocity(missing()), change = largest_velocity(found_);
  const Box& bounds = surface_.at_t1().report().bounds;
  const double furthest = std::max(largest_magnitude(bounds.low), largest_magnitude(bounds.high));
  const double rounding = std::max(1e-12 * surface_.size(), 32 * std::numeric_limits<double>::epsilon() * furthest);  // [m]
  return !(error > share * change && dt_ * error > rounding);
}

// (1 + K A) x, of the active coordinates.
void StructureCoupling::multiply(std::span<const double> x, std::span<double> product) const {
  std::vector<double> velocity(x.size(), 0.0);
  structure_.velocity_change(active_, x, velocity);
  for (const std::size_t c : active_) product[c] = x[c];
  for (const Place& place : places_) {
    const Vec3d change = velocity_at(place, velocity);
    const Vec3d impulse = place.sticks ? place.mass * change : (place.mass * dot(place.normal, change)) * place.along;
    for (std::size_t k = 0; k < 3; ++k) structure_.add_vertex_impulse(static_cast<std::size_t>(place.vertices[k]), place.weights[k] * impulse, product);
  }
}

// BiCGSTAB, from x = right. If it breaks down, the next pass continues from the x reached.
void StructureCoupling::solve(std::span<const double> right, std::span<double> x) const {
  constexpr int max_iterations = 200;
  constexpr double tolerance = 1e-10;
  const auto dot_of = [&](std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (const std::size_t c : active_) sum += a[c] * b[c];
    return sum;
  };
  const std::size_t size = right.size();
  std::vector<double> r(size), shadow(size), p(size), v(size), s(size), t(size);
  for (const std::size_t c : active_) x[c] = right[c];
  multiply(x, r);
  for (const std::size_t c : active_) p[c] = shadow[c] = r[c] = right[c] - r[c];
  const double enough = tolerance * tolerance * dot_of(right, right);
  double rho = dot_of(shadow, r);
  for (int iteration = 0; iteration < max_iterations && dot_of(r, r) > enough; ++iteration) {
    multiply(p, v);
    const double alpha = rho / dot_of(shadow, v);
    if (!std::isfinite(alpha)) return;
    for (const std::size_t c : active_) s[c] = r[c] - alpha * v[c];
    multiply(s, t);
    const double squared = dot_of(t, t), omega = squared > 0 ? dot_of(t, s) / squared : 0;
    for (const std::size_t c : active_) x[c] += alpha * p[c] + omega * s[c], r[c] = s[c] - omega * t[c];
    const double next = dot_of(shadow, r), beta = next / rho * alpha / omega;
    if (!std::isfinite(beta)) return;
    rho = next;
    for (const std::size_t c : active_) p[c] = r[c] + beta * (p[c] - omega * v[c]);
  }
}

// Includes the vertices in contact in this pass.
void StructureCoupling::activate() {
  for (const Place& place : places_) touched_.insert(touched_.end(), place.vertices.begin(), place.vertices.end());
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  active_ = structure_.coordinates_of(touched_);
}

void StructureCoupling::correct() {
  end_pass();
  std::vector<double> change(assumed_.size(), 0.0);
  solve(missing(), change);
  for (const std::size_t c : active_) assumed_[c] += change[c];
  move();
}

void StructureCoupling::retreat() {
  end_pass();
  assumed_ = best_;
  move();
}

void StructureCoupling::end_pass() {
  activate();
  const double error = largest_velocity(missing());
  if (!(error < least_error_)) return;
  least_error_ = error;
  best_ = assumed_;
}

void StructureCoupling::move() {
  std::fill(found_.begin(), found_.end(), 0.0);
  places_.clear();
  structure_.move(assumed_, vertices_);
  correction_ = surface_.move_again(vertices_);
}

double StructureCoupling::finish() { return structure_.finish(assumed_, found_); }

}  // namespace fccda
