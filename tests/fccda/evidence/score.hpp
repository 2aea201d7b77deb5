/// The result of a detector on passages of known classification.
#pragma once

#include "fccda/evidence/passages.hpp"

namespace evidence {

struct Score {
  std::size_t contacts = 0;  ///< true ones
  std::size_t found = 0;     ///< of them
  std::size_t past = 0;      ///< paths that stay outside
  std::size_t invented = 0;  ///< of them, reported as contacts
  // of the contacts found:
  std::size_t inside = 0;  ///< relocated inside, or nearer than the contact radius
  std::size_t thrown = 0;  ///< relocated outside, with a path from the start through the surface

  Score& operator+=(const Score& b) {
    contacts += b.contacts, found += b.found, past += b.past, invented += b.invented, inside += b.inside, thrown += b.thrown;
    return *this;
  }
};

/// `missed(passage, number)` is called for each true contact that was not found.
template <class Detector, class Missed>
Score score(Detector& detector, const Truth& truth, const Flight& flight, Way way, double radius, const Missed& missed) {
  // Relocated points have the offset, 1e-12 of the size, which covers the rounding of two poses; ten times that counts as inside.
  constexpr double rounding = 1e-11;
  const fixtures::TestPoints points = flight.points(way);
  detector.forget();
  const std::vector<Contact> contacts = fixtures::detect(detector, points, flight.motion, travel_bound(flight.motion, {}, 1));
  std::vector<const Contact*> of(points.size(), nullptr);
  for (const Contact& contact : contacts) of[contact.point] = &contact;
  Score total;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Passage& passage = flight.passages[i];
    (passage.is_contact() ? total.contacts : total.past) += 1;
    if (!of[i]) {
      if (passage.is_contact()) missed(passage, i);
      continue;
    }
    if (!passage.is_contact()) {
      ++total.invented;
      continue;
    }
    ++total.found;
    const Vec3d place = flight.motion.t1.to_body(of[i]->relocation);
    const double distance = truth.distance(place);
    const double too_deep = truth.inside(place) ? radius + distance : radius - distance;
    const Path straight{passage.path.start, Path{passage.path.start, place}.at(1 - 1e-6)};  // short of its final position
    if (too_deep > rounding)
      ++total.inside;
    else if (truth.first_crossing(straight) && (flight.bulge == 0 || depth(truth, straight) > flight.bulge))  // the true path goes round a bulge
      ++total.thrown;
  }
  return total;
}

}  // namespace evidence
