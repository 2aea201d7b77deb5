#include "fccda/api/deforming_contact_detector.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "fccda/api/array_points.hpp"
#include "fccda/api/contact_arrays.hpp"

namespace fccda {

// Returns the offset that the rounding of coordinates in single precision needs in this step; 0 in double precision.
double DeformingContactDetector::measure(ConstVectors x_t0, ConstVectors x_t1, double radius) {
  const double size = detector_.surface().size();
  measure_paths(x_t0, x_t1, ContactDetector::longest_path * size, travel_);
  detector_.set_rounding(rounding_of(x_t1));
  const double offset = x_t1.is_single() ? detector_.offset() : 0;
  expect_small_offset(offset, radius, size);
  return offset;
}

void DeformingContactDetector::points_changed() {
  detector_.renumbered();
  radii_.forget();
}

std::vector<DeformingContact> DeformingContactDetector::detect(ConstVectors x_t0, ConstVectors x_t1) {
  measure(x_t0, x_t1, detector_.radius());
  if (radii_.known()) detector_.forget();  // the points had other radii in the previous step
  radii_.note_common(detector_.radius(), x_t1.size());
  for (const std::size_t i : radii_.grown()) detector_.grown(i);
  std::vector<DeformingContact> contacts;
  detector_.detect(ArrayPoints(x_t0, x_t1, travel_), contacts);
  return contacts;
}

// A point with a larger radius is evaluated again. If it now starts inside, it counts as pushed there.
std::vector<DeformingContact> DeformingContactDetector::detect(ConstVectors x_t0, ConstVectors x_t1, const Numbers& radius) {
  const double offset = measure(x_t0, x_t1, 0);
  const bool others = !radii_.known();
  const double largest = radii_.note(radius, x_t1.size(), offset);
  if (others) detector_.forget();
  for (const std::size_t i : radii_.grown()) detector_.grown(i);
  std::vector<DeformingContact> contacts;
  detector_.detect(ArrayBalls(ArrayPoints(x_t0, x_t1, travel_), radius, largest), contacts);
  return contacts;
}

std::vector<std::size_t> DeformingContactDetector::points_inside(ConstVectors x) const { return points_inside(x, detector_.radius()); }

std::vector<std::size_t> DeformingContactDetector::points_inside(ConstVectors x, const Numbers& radius) const {
  expect_radii(radius, x.size());
  expect_finite_positions(x);
  for (std::size_t i = 0; i < x.size(); ++i) checked_radius(radius[i]);
  return detector_.initial_overlap(ArrayBalls(ArrayPoints(x, x, {}), radius, 0));
}

ContactDetector::State DeformingContactDetector::state() const {
  ContactDetector::State state;
  detector_.visit_state(StateReader{state});
  state.entered = detector_.entered_inside();
  return state;
}

void DeformingContactDetector::resume(const ContactDetector::State& state) {
  expect_ordered(state);
  detector_.visit_state(StateWriter{state});
  detector_.visit_record(RecordWriter{state});
  detector_.forget();
  radii_.forget();
}

ContactSum respond(std::span<const DeformingContact> contacts, double dt, const PointArrays& points, double friction, const Numbers& vertex_mass,
                   Vectors vertex_impulses) {
  if (!(dt > 0 && std::isfinite(dt)))
    throw InputError("contact: the step has a duration of " + in_words(dt) + " s, but velocities need a positive one; pass that of the step.");
  expect_equally_long(points);
  expect_friction(friction);
  const std::size_t vertices = vertex_impulses.size();
  if (!vertex_mass.are_for(vertices))
    throw InputError("contact: the number of masses of vertices differs from the " + std::to_string(vertices) +
                     " impulses; give one for each vertex of the panels, or one number for all.");
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const DeformingContact& contact = contacts[c];
    expect_usable_point(points, contact.contact.point);
    if (c > 0) expect_later(contact.contact.point, contacts[c - 1].contact.point);
    for (const int vertex : contact.place.vertices) {
      const auto v = static_cast<std::size_t>(vertex);
      if (v >= vertices)
        throw InputError("contact: there is a contact of vertex " + std::to_string(v) + ", but there are impulses of " + std::to_string(vertices) +
                         " vertices only; give one for each vertex of the panels.");
      if (!(vertex_mass[v] > 0))
        throw InputError("contact: the mass of vertex " + std::to_string(v) + " is " + in_words(vertex_mass[v]) +
                         " kg, but it must be positive; it is infinite where motion is prescribed.");
      if (!is_finite(vertex_impulses[v])) expect_finite(vertex_impulses[v], "contact: the impulse on vertex " + std::to_string(v) + " so far");
    }
  }
  std::vector<Vec3d> impulses(vertices);
  ContactArrays resolved{points};
  const ContactSum sum = respond(
      resolved, contacts, dt, friction, [&](std::size_t v) { return 1 / vertex_mass[v]; }, impulses);
  for (const DeformingContact& contact : contacts)
    for (const int vertex : contact.place.vertices) {
      const auto v = static_cast<std::size_t>(vertex);
      vertex_impulses.set(v, vertex_impulses[v] + impulses[v]);
      impulses[v] = {};  // added already
    }
  return sum;
}

}  // namespace fccda
