#include "fccda/detect/swept.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fccda {

namespace {

bool same(const Pose& a, const Pose& b) {
  const Quaternion &p = a.attitude(), &q = b.attitude();
  return a.position() == b.position() && p.w == q.w && p.x == q.x && p.y == q.y && p.z == q.z;
}

}  // namespace

void Swept::begin_step(std::size_t point_count, double largest_radius, const Motion& motion) {
  expect_usable(motion);
  sides_.begin(point_count);
  if (!same(pose_, motion.t0)) cache_.forget();
  pose_ = motion.t1;
  measure(largest_radius, motion);
}

// Points in contact have no clearance, so all of them are evaluated again; those that entered or left may have some.
void Swept::begin_again(double largest_radius, const Motion& motion) {
  for (const std::uint64_t point : sides_.changed()) cache_.forget(point);
  sides_.begin_again();
  pose_ = motion.t1;
  measure(largest_radius, motion);
}

double Swept::offset(const Motion& motion) const {
  const Vec3d reach = max(max(test_.surface().report().bounds.high, -test_.surface().report().bounds.low), Vec3d{});
  const double largest = norm(reach) + std::max(largest_magnitude(motion.t0.position()), largest_magnitude(motion.t1.position()));
  // Rounding a relocated position moves it by at most sqrt(3) roundings of a coordinate; twice that keeps it outside.
  return std::max({1e-12 * test_.size(), 32 * std::numeric_limits<double>::epsilon() * largest, 4 * rounding_ * largest});
}

// Bound of how much nearer to the surface the chord of a point's path in the rotating body frame can come, for a travel of m = (point) +
// (surface) from end to end. The true path comes nearer by at most m. It deviates from its chord by at most (ρ θ² + 2 θ w)/8, a twice
// integrated acceleration. Here ρ <= R + d is the point's distance from the centre of mass, d that from the surface, and w <= m its path
// length. m includes R θ²/8 already. So contact is impossible while d > r + m + d θ²/8 + θ m/4, that is while
//   d - r > κ (1 + θ/4) m + (κ - 1) r,   κ = 1/(1 - θ²/8).
void Swept::measure(double largest_radius, const Motion& motion) {
  step_.offset = offset(motion);
  const double angle = rotation_angle(motion);
  constexpr double largest_angle = 1;  // κ is 1.14 there
  if (!(angle <= largest_angle)) {
    forget();
    step_.stretch = 1, step_.allowance = 0;
    return;
  }
  const double kappa = 1 / (1 - angle * angle / 8);
  step_.stretch = kappa * (1 + angle / 4);
  step_.allowance = (kappa - 1) * largest_radius;
}

void Swept::grown(std::size_t i) {
  cache_.forget(i);
  if (!test_.surface().is_closed()) sides_.press(i);
}

void Swept::forget() {
  cache_.forget();
  std::fill(guess_.begin(), guess_.end(), -1);
}

void Swept::renumbered() {
  forget();
  sides_.renumber();
}

void Swept::evaluate(std::size_t block, std::size_t point, double radius, const Vec3d& position_t0, const Vec3d& position_t1, const BodyView& view,
                     double look_ahead, Found& found) {
  const CurvedPath path = view.path(position_t0, position_t1);
  const bool entered = sides_.has_entered(point);
  const bool fresh = cache_.is_new(point);
  const PathResult result = test_.evaluate({.path = path,
                                            .radius = radius,
                                            .offset = step_.offset,
                                            .look_ahead = fresh ? Bvh::no_cap : look_ahead,
                                            .entered = entered,
                                            .in_contact = sides_.was_in_contact(point),
                                            .renumbered = sides_.was_renumbered()},
                                           guess_[point], found.effort);
  cache_.postpone(block, point, result.clearance);
  found.sides.note(point, result, entered, !test_.surface().is_closed());
  if (!result.contact) return;
  const Motion& motion = view.motion();
  const BodyFrameContact& contact = *result.contact;
  found.contacts.push_back({.point = point,
                            .panel = test_.surface().triangles()[static_cast<std::size_t>(contact.triangle)].panel,
                            .time_fraction = contact.time_fraction,
                            .hit = motion.t1.to_world(contact.hit),
                            .normal = motion.t1.turn_to_world(contact.normal),
                            .relocation = motion.t1.to_world(contact.relocation),
                            .depth = norm(contact.relocation - path.chord().end),
                            .radius = radius,
                            .offset = rounding_ > 0 ? step_.offset : 0,
                            .normal_t0 = motion.t0.turn_to_world(contact.normal_t0),
                            .sliding = this});
}

Vec3d Swept::slide(const Pose& pose, const Vec3d& from, const Vec3d& to, double radius) const {
  const Vec3d end = pose.to_body(to), reached = test_.slide(pose.to_body(from), end, radius, step_.offset);
  return reached == end ? to : pose.to_world(reached);
}

void Swept::gather(std::size_t shares, std::vector<Contact>& out) { fccda::gather(std::span<const Found>(found_).first(shares), out, sides_, effort_); }

}  // namespace fccda
