#include "fccda/elastic/elastic_body.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "base/parallel.hpp"
#include "fccda/respond/coupling.hpp"

namespace fccda {

namespace {

void expect_usable(const Modes& modes, std::size_t vertices) {
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const Mode& mode = modes[k];
    const std::string which = "elastic body: mode " + std::to_string(k + 1) + " ";
    if (mode.shape.size() != vertices)
      throw InputError(which + "has a shape of " + std::to_string(mode.shape.size()) + " vertices, but the surface has " + std::to_string(vertices) + ".");
    if (!mode.stress.empty() && mode.stress.size() != vertices)
      throw InputError(which + "has stresses at " + std::to_string(mode.stress.size()) + " vertices, but the surface has " + std::to_string(vertices) + ".");
    if (!(mode.angular_frequency > 0 && std::isfinite(mode.angular_frequency)))
      throw InputError(which + "has the angular frequency " + in_words(mode.angular_frequency) +
                       " rad/s, but it must be positive; leave out rigid-body modes, which the rigid motion contains.");
    if (!(mode.damping_ratio >= 0 && mode.damping_ratio < 1))
      throw InputError(which + "has the damping ratio " + in_words(mode.damping_ratio) + ", but it must be at least 0 and below 1.");
    for (const Vec3d& shape : mode.shape)
      if (!std::isfinite(squared_norm(shape))) throw InputError(which + "has a shape that is not finite.");
  }
}

Impulse rigid_part(std::span<const double> p) { return {{p[0], p[1], p[2]}, {p[3], p[4], p[5]}}; }

}  // namespace

ElasticBody::ElasticBody(RigidBody& body, Modes modes, std::span<const Vec3d> vertices)
    : body_(body),
      modes_(std::move(modes)),
      vertices_(vertices.begin(), vertices.end()),
      amplitude_(modes_.size(), 0.0),
      velocity_(amplitude_),
      last_impulse_(amplitude_),
      at_t0_(body),
      amplitude_t0_(amplitude_),
      velocity_t0_(amplitude_) {
  expect_usable(modes_, vertices_.size());
  shapes_.resize(vertices_.size() * modes_.size());
  for (std::size_t k = 0; k < modes_.size(); ++k)
    for (std::size_t v = 0; v < vertices_.size(); ++v) shapes_[v * modes_.size() + k] = modes_[k].shape[v];
}

double ElasticBody::largest_angle(std::span<const Mode> modes, double dt) {
  double largest = 0;
  for (const Mode& mode : modes) largest = std::max(largest, mode.angular_frequency * dt);
  return largest;
}

void ElasticBody::prepare(double dt) {
  if (dt == dt_) return;
  dt_ = dt;
  propagators_.clear();
  for (const Mode& mode : modes_) {
    const double w = mode.angular_frequency, decay = mode.damping_ratio * w, damped = w * std::sqrt(1 - mode.damping_ratio * mode.damping_ratio);
    const double e = std::exp(-decay * dt), c = e * std::cos(damped * dt), s = e * std::sin(damped * dt) / damped;
    propagators_.push_back({c + decay * s, s, -w * w * s, c - decay * s});
  }
}

void ElasticBody::begin(const Step& step) {
  prepare(step.dt);
  at_t0_ = body_;
  amplitude_t0_ = amplitude_;
  velocity_t0_ = velocity_;
}

void ElasticBody::move(std::span<const double> impulse, std::span<Vec3d> vertices) {
  body_ = at_t0_;
  push(body_, rigid_part(impulse));
  body_.advance(dt_);
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const Propagator& p = propagators_[k];
    const double q = amplitude_t0_[k], v = velocity_t0_[k] + impulse[6 + k];
    amplitude_[k] = p.qq * q + p.qv * v;
    velocity_[k] = p.vq * q + p.vv * v;
  }
  place(vertices);
}

Vec3d ElasticBody::deflection(std::size_t vertex) const {
  Vec3d sum{};
  const Vec3d* shape = shapes_.data() + vertex * modes_.size();
  for (std::size_t k = 0; k < modes_.size(); ++k) sum += amplitude_[k] * shape[k];
  return sum;
}

void ElasticBody::place(std::span<Vec3d> vertices) const {
  parallel_for(static_cast<std::ptrdiff_t>(vertices_.size()), [&](std::ptrdiff_t i) {
    const auto v = static_cast<std::size_t>(i);
    vertices[v] = body_.pose().to_world(vertices_[v] + deflection(v));
  });
}

std::vector<Vec3d> ElasticBody::deformed() const {
  std::vector<Vec3d> places(vertices_);
  for (std::size_t v = 0; v < places.size(); ++v) places[v] += deflection(v);
  return places;
}

SymmetricTensor ElasticBody::stress(std::size_t vertex) const {
  SymmetricTensor sum{};
  for (std::size_t k = 0; k < modes_.size(); ++k)
    if (!modes_[k].stress.empty())
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += amplitude_[k] * modes_[k].stress[vertex][c];
  return sum;
}

std::vector<std::size_t> ElasticBody::coordinates_of(std::span<const int>) const {
  std::vector<std::size_t> all(size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

void ElasticBody::velocity_change(std::span<const std::size_t>, std::span<const double> impulse, std::span<double> velocity) const {
  const Impulse rigid = rigid_part(impulse);
  const Twist twist = at_t0_.velocity_change(rigid.linear, rigid.angular);
  for (std::size_t c = 0; c < 3; ++c) velocity[c] = twist.velocity[c], velocity[3 + c] = twist.spin[c];
  for (std::size_t k = 0; k < modes_.size(); ++k) velocity[6 + k] = propagators_[k].qv / dt_ * impulse[6 + k];
}

// Both at t1, where the impulses of the contacts act.
Vec3d ElasticBody::vertex_velocity(std::size_t vertex, std::span<const double> velocity) const {
  const Impulse rigid = rigid_part(velocity);
  Vec3d local{};
  const Vec3d* shape = shapes_.data() + vertex * modes_.size();
  for (std::size_t k = 0; k < modes_.size(); ++k) local += velocity[6 + k] * shape[k];
  const Vec3d arm = body_.pose().to_world(vertices_[vertex] + deflection(vertex)) - body_.position_of_com();
  return rigid.linear + cross(rigid.angular, arm) + body_.pose().turn_to_world(local);
}

void ElasticBody::add_vertex_impulse(std::size_t vertex, const Vec3d& impulse, std::span<double> generalised) const {
  const Vec3d arm = body_.pose().to_world(vertices_[vertex] + deflection(vertex)) - body_.position_of_com(), moment = cross(arm, impulse);
  for (std::size_t c = 0; c < 3; ++c) generalised[c] += impulse[c], generalised[3 + c] += moment[c];
  const Vec3d local = body_.pose().turn_to_body(impulse);
  const Vec3d* shape = shapes_.data() + vertex * modes_.size();
  for (std::size_t k = 0; k < modes_.size(); ++k) generalised[6 + k] += dot(shape[k], local);
}

double ElasticBody::finish(std::span<const double> assumed, std::span<const double> found) {
  RigidBody pushed = at_t0_;
  const Impulse before = rigid_part(assumed), total = rigid_part(found);
  double work = push(pushed, before) + push(body_, {total.linear - before.linear, total.angular - before.angular});
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const double first = assumed[6 + k], rest = found[6 + k] - first, squared = modes_[k].angular_frequency * modes_[k].angular_frequency;
    const double after_impulse = velocity_t0_[k] + first;
    work += first * (velocity_t0_[k] + 0.5 * first) + rest * (velocity_[k] + 0.5 * rest);
    if (modes_[k].damping_ratio > 0)
      dissipation_ += 0.5 * (after_impulse * after_impulse + squared * amplitude_t0_[k] * amplitude_t0_[k]) -
                      0.5 * (velocity_[k] * velocity_[k] + squared * amplitude_[k] * amplitude_[k]);
    velocity_[k] += rest;
    last_impulse_[k] = found[6 + k];
  }
  return work;
}

double ElasticBody::kinetic_energy() const {
  double energy = 0;
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const double velocity = velocity_[k] + 0.5 * last_impulse_[k];
    energy += 0.5 * velocity * velocity;
  }
  return energy;
}

double ElasticBody::kinetic_energy_of_scheme() const {
  double energy = 0;
  for (const double velocity : velocity_) energy += 0.5 * velocity * velocity;
  return energy;
}

double ElasticBody::elastic_energy() const {
  double energy = 0;
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const double speed = modes_[k].angular_frequency * amplitude_[k];
    energy += 0.5 * speed * speed;
  }
  return energy;
}

}  // namespace fccda
