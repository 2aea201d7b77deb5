#include "fccda/deforming/deforming.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/finite.hpp"

namespace fccda {

namespace {

double largest_coordinate(const Surface& surface) {
  const Box& bounds = surface.report().bounds;
  return std::max(largest_magnitude(bounds.low), largest_magnitude(bounds.high));
}

}  // namespace

Deforming::Deforming(std::shared_ptr<const DeformingSurface> surface, double radius) : surface_(std::move(surface)), radius_(radius) {
  if (!(radius >= 0 && std::isfinite(radius)))
    throw InputError("contact: the contact radius is " + in_words(radius) + " m, but it must be a number of at least 0; 0 is for points without extent.");
}

void Deforming::begin_step() {
  const std::uint64_t now = surface_->steps();
  if (now > 0 && now == step_)
    throw InputError("contact: the deforming surface was not moved since the last detection; call move() once in each step, even if it is at rest.");
  if (now != step_ + 1) cache_.forget();  // cached distances refer to where it was then
  step_ = now;
  if (cache_.differs_from(blocks_)) {
    cache_.start(blocks_);
    guess_.assign(blocks_.back(), -1);
  }
  sides_.begin(blocks_.back());
  offset_ = offset();
}

// Points in contact have no clearance, so all of them are evaluated again; those that entered or left may have some.
void Deforming::begin_again() {
  for (const std::uint64_t point : sides_.changed()) cache_.forget(point);
  sides_.begin_again();
  offset_ = offset();
}

double Deforming::offset() const {
  // As Swept: rounding a relocated position moves it by at most sqrt(3) roundings of a coordinate; twice that keeps it outside.
  const double largest = std::max(largest_coordinate(surface_->at_t0()), largest_coordinate(surface_->at_t1()));
  return std::max({1e-12 * surface_->size(), 32 * std::numeric_limits<double>::epsilon() * largest, 4 * rounding_ * largest});
}

void Deforming::grown(std::size_t i) {
  cache_.forget(i);
  if (!surface_->at_t1().is_closed()) sides_.press(i);
}

void Deforming::forget() {
  cache_.forget();
  std::fill(guess_.begin(), guess_.end(), -1);
}

void Deforming::renumbered() {
  forget();
  sides_.renumber();
}

bool Deforming::is_inside(const Vec3d& point, double radius) const {
  const MovingPathTest test(*surface_);
  std::size_t tested = 0;
  const std::optional<ClosestPoint> closest = surface_->bvh_t1().closest(point);
  return closest && test.at_t1().too_near(*closest, point, radius - 1e-9 * surface_->size(), tested);
}

void Deforming::evaluate(const MovingPathTest& test, std::size_t block, std::size_t point, double radius, const Path& path, double look_ahead, Found& found) {
  const bool entered = sides_.has_entered(point);
  const PathResult result = test.evaluate({.path = path,
                                           .radius = radius,
                                           .offset = offset_,
                                           .look_ahead = cache_.is_new(point) ? Bvh::no_cap : look_ahead,
                                           .entered = entered,
                                           .in_contact = sides_.was_in_contact(point),
                                           .renumbered = sides_.was_renumbered()},
                                          guess_[point], found.effort);
  cache_.postpone(block, point, result.clearance);
  const Surface& surface = surface_->at_t1();
  found.sides.note(point, result, entered, !surface.is_closed());
  if (!result.contact) return;
  const BodyFrameContact& contact = *result.contact;
  const auto t = static_cast<std::size_t>(contact.triangle);
  const MovingTriangle triangle = surface_->triangle(t);
  const std::array<double, 3> weights = barycentric(triangle.t1, contact.relocation);
  const Corners &from = triangle.t0, &to = triangle.t1;
  found.contacts.push_back({.contact = {.point = point,
                                        .panel = surface.triangles()[t].panel,
                                        .time_fraction = contact.time_fraction,
                                        .hit = contact.hit,
                                        .normal = contact.normal,
                                        .relocation = contact.relocation,
                                        .depth = norm(contact.relocation - path.end),
                                        .radius = radius,
                                        .offset = rounding_ > 0 ? offset_ : 0,
                                        .normal_t0 = contact.normal_t0,
                                        .sliding = this},
                            .place = {.vertices = surface_->panel_vertices(t),
                                      .weights = weights,
                                      .corners = to,
                                      .displacement = weights[0] * (to.a - from.a) + weights[1] * (to.b - from.b) + weights[2] * (to.c - from.c)}});
}

Vec3d Deforming::slide(const Pose&, const Vec3d& from, const Vec3d& to, double radius) const {
  return MovingPathTest(*surface_).at_t1().slide(from, to, radius, offset_);
}

void Deforming::gather(std::size_t shares, std::vector<DeformingContact>& out) {
  fccda::gather(std::span<const Found>(found_).first(shares), out, sides_, effort_);
}

}  // namespace fccda
