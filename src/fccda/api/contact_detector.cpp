#include "fccda/api/contact_detector.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "fccda/api/array_points.hpp"
#include "fccda/api/contact_arrays.hpp"

namespace fccda {

namespace {

double size_of(const Surface& surface) { return largest_magnitude(surface.report().bounds.size()); }

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
    : swept_(std::move(surface), options.contact_bounds, checked_radius(options.radius)),
      centre_(swept_.surface().report().bounds.centre()),
      reach_(swept_.surface().radius_about(centre_)),
      longest_path_(longest_path * size_of(swept_.surface())) {}

// The offset that the rounding of coordinates in single precision needs in this step; 0 in double precision.
double ContactDetector::offset_of(ConstVectors x, const Motion& motion) {
  swept_.set_rounding(rounding_of(x));
  return x.is_single() ? swept_.offset(motion) : 0;
}

// A point with a larger radius is evaluated again. If it now starts inside, it counts as pushed there.
double ContactDetector::note_radii(const Numbers& radius, std::size_t points, double offset) {
  const bool others = !radii_.known();
  const double largest = radii_.note(radius, points, offset);
  if (others) swept_.forget();
  for (const std::size_t i : radii_.grown()) swept_.grown(i);
  return largest;
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
  state.entered = swept_.entered_inside();
  return state;
}

void ContactDetector::resume(const State& state) {
  expect_ordered(state);
  swept_.visit_state(StateWriter{state});
  swept_.visit_record(RecordWriter{state});
  swept_.forget();
  radii_.forget();
}

void ContactDetector::points_changed() {
  swept_.renumbered();
  radii_.forget();
}

std::vector<Contact> ContactDetector::detect(const Motion& motion, ConstVectors x_t0, ConstVectors x_t1) {
  expect_usable(motion);
  measure_paths(x_t0, x_t1, longest_path_, travel_);
  expect_small_offset(offset_of(x_t1, motion), swept_.radius(), size_of(swept_.surface()));
  if (radii_.known()) swept_.forget();  // the points had other radii in the previous step
  radii_.note_common(swept_.radius(), x_t1.size());
  for (const std::size_t i : radii_.grown()) swept_.grown(i);
  return contacts_of(ArrayPoints(x_t0, x_t1, travel_), motion);
}

std::vector<Contact> ContactDetector::detect(const Motion& motion, ConstVectors x_t0, ConstVectors x_t1, const Numbers& radius) {
  expect_usable(motion);
  measure_paths(x_t0, x_t1, longest_path_, travel_);
  const double offset = offset_of(x_t1, motion);
  expect_small_offset(offset, 0, size_of(swept_.surface()));
  const double largest = note_radii(radius, x_t1.size(), offset);
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
