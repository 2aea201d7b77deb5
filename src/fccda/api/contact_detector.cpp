#include "fccda/api/contact_detector.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "fccda/api/array_points.hpp"
#include "fccda/api/contact_arrays.hpp"

namespace fccda {

namespace {

bool is_radius(double radius) { return radius >= 0 && std::isfinite(radius); }

double checked_radius(double radius) {
  if (is_radius(radius)) return radius;
  throw InputError("contact: the contact radius is " + in_words(radius) + " m, but it must be a number of at least 0; 0 is for points without extent.");
}

double size_of(const Surface& surface) { return largest_magnitude(surface.report().bounds.size()); }

void expect_radii(const Numbers& radius, std::size_t points) {
  if (!radius.are_for(points))
    throw InputError("contact: the number of radii differs from the " + std::to_string(points) + " points; give one for each, or one number for all.");
}

}  // namespace

void expect_ordered(const ContactDetector::State& state) {
  if (!std::ranges::is_sorted(state.inside) || !std::ranges::is_sorted(state.in_contact))
    throw InputError("contact: the points of a detector's state are not in ascending order; pass what state() returned.");
}

void expect_finite_positions(ConstVectors x) {
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!is_finite(x[i])) throw RunError("contact: point " + std::to_string(i) + " is at " + in_words(x[i]) + ", which is not finite.");
}

ContactDetector::ContactDetector(SharedSurface surface, const Options& options)
    : swept_(std::move(surface), options.region, checked_radius(options.radius)),
      centre_(swept_.surface().report().bounds.centre()),
      reach_(swept_.surface().radius_about(centre_)),
      longest_path_(longest_path * size_of(swept_.surface())) {}

// A known distance is a distance beyond the point's contact radius. So a point with a larger radius is evaluated again. If it now starts
// inside, it counts as pushed there.
double ContactDetector::note_radii(const Numbers& radius, std::size_t points) {
  expect_radii(radius, points);
  if (radius_.empty()) swept_.forget();
  std::vector<double> largest(blocks_of(points));
  std::vector<std::uint8_t> differs(largest.size());
  const auto scan = [&](std::ptrdiff_t block) {
    const auto b = static_cast<std::size_t>(block);
    for (std::size_t i = b * block_size; i < std::min((b + 1) * block_size, points); ++i) {
      const double now = radius[i];
      if (!is_radius(now) || i >= radius_.size() || now != radius_[i]) differs[b] = 1;
      largest[b] = std::max(largest[b], now);
    }
  };
  for_blocks(largest.size(), scan);
  const std::size_t known = radius_.size();
  radius_.resize(points);
  for (std::size_t b = 0; b < differs.size(); ++b) {
    if (differs[b] == 0) continue;
    for (std::size_t i = b * block_size; i < std::min((b + 1) * block_size, points); ++i) {
      const double now = radius[i];
      if (!is_radius(now))
        throw InputError("contact: the radius of point " + std::to_string(i) + " is " + in_words(now) + " m, but it must be a number of at least 0.");
      if (i < known && now > radius_[i]) swept_.grown(i);
      radius_[i] = now;
    }
  }
  return points == 0 ? 0 : *std::ranges::max_element(largest);
}

template <class P>
std::vector<Contact> ContactDetector::contacts_of(const P& points, const Motion& motion) {
  std::vector<Contact> contacts;
  const double reach = norm(motion.centre - centre_) + reach_;  // radius of the surface about the centre of rotation
  swept_.detect(points, motion, travel_bound(motion, motion.centre, reach), contacts);
  return contacts;
}

ContactDetector::State ContactDetector::state() const {
  State state;
  swept_.visit_state(StateReader{state});
  return state;
}

void ContactDetector::resume(const State& state) {
  expect_ordered(state);
  swept_.visit_state(StateWriter{state});
  swept_.forget();
}

std::vector<Contact> ContactDetector::detect(const Motion& motion, ConstVectors x_t0, ConstVectors x_t1) {
  expect_usable(motion);
  measure_paths(x_t0, x_t1, longest_path_, travel_);
  if (!radius_.empty()) swept_.forget(), radius_.clear();  // the points had other radii in the previous step
  swept_.set_rounding(rounding_of(x_t1));
  return contacts_of(ArrayPoints(x_t0, x_t1, travel_), motion);
}

std::vector<Contact> ContactDetector::detect(const Motion& motion, ConstVectors x_t0, ConstVectors x_t1, const Numbers& radius) {
  expect_usable(motion);
  measure_paths(x_t0, x_t1, longest_path_, travel_);
  const double largest = note_radii(radius, x_t1.size());
  swept_.set_rounding(rounding_of(x_t1));
  return contacts_of(ArrayBalls(ArrayPoints(x_t0, x_t1, travel_), radius, largest), motion);
}

std::vector<std::size_t> ContactDetector::points_inside(const Pose& pose, ConstVectors x) const { return points_inside(pose, x, swept_.radius()); }

std::vector<std::size_t> ContactDetector::points_inside(const Pose& pose, ConstVectors x, const Numbers& radius) const {
  expect_usable(pose, "contact: ");
  expect_radii(radius, x.size());
  expect_finite_positions(x);
  for (std::size_t i = 0; i < x.size(); ++i) checked_radius(radius[i]);
  return swept_.initial_overlap(ArrayBalls(ArrayPoints(x, x, {}), radius, 0), pose);
}

}  // namespace fccda
