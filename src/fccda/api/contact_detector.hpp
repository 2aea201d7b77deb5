/// Contact detection as a plain function call: positions before and after a step in, contacts out. This is the swept detector
/// (detect/swept.hpp, a form of continuous collision detection) over arrays. A solver with its own blocks and bounds uses that detector
/// through the Points interface (detect/points.hpp) instead.
///   ContactDetector detector{Surface(read_panels("hull.stl")), {.radius = 0.01}};
///   while (...) {
///     const Motion motion = hull.advance(dt);                                     // RigidBody, or any two poses
///     ...                                                                         // x_t1 of the solver
///     const std::vector<Contact> contacts = detector.detect(motion, x_t0, x_t1);
///     respond(contacts, motion, hull, {x_t0, x_t1, velocity, mass});              // api/respond_arrays.hpp
///   }
///
/// Several detectors may share one surface with its search structures (search/indexed_surface.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "fccda/api/radii.hpp"
#include "fccda/api/vectors.hpp"
#include "fccda/detect/swept.hpp"

namespace fccda {

/// A detector of contact for one set of points. It caches each point's distance from the surface, so that most points need no evaluation.
class ContactDetector {
 public:
  /// What a detector is built with, besides its surface.
  struct Options {
    double radius = 0;                           ///< [m] contact radius: points are balls; 0 for points without extent. Overridden by radii passed to detect()
    ContactBounds contact_bounds = Unbounded();  ///< in the body frame
  };

  /// Throws InputError if the radius is negative or not finite.
  ContactDetector(SharedSurface surface, const Options& options);
  /// Without contact radius and contact bounds.
  explicit ContactDetector(SharedSurface surface) : ContactDetector(std::move(surface), Options{}) {}
  /// With a surface of its own.
  ContactDetector(Surface surface, const Options& options) : ContactDetector(share(std::move(surface)), options) {}
  /// With a surface of its own, without contact radius and contact bounds.
  explicit ContactDetector(Surface surface) : ContactDetector(std::move(surface), Options{}) {}

  /// The contacts of one step, in point order, bitwise identical for any number of threads. x_t0 and x_t1 [m] are positions in the world
  /// frame at the two ends of the step. x_t0 must equal x_t1 of the previous step after relocation; see below for other points. motion.t0
  /// should be motion.t1 of the previous step; if the body was moved in between, all points are evaluated again. Points may be appended
  /// or removed at the end between steps, but not both between the same two, unless each number that is used again is reported as moved. To repeat a step,
  /// save state() before it and resume() that state before detecting again; the same after an exception. Throws InputError if x_t0 and x_t1 differ in number or
  /// the motion is not finite. Throws RunError if a position is not finite, or a point moves farther in the step than `longest_path` sizes of the surface.
  ///
  /// Positions in single precision are relocated to an offset o of 2.4e-7 of the largest coordinate of the surface beyond the contact radius, so that
  /// rounding moves none inside, and are in contact from as much below it (Contact::offset). Throws InputError if o is more than a tenth of the radius,
  /// or of the surface's size for points without extent.
  std::vector<Contact> detect(const Motion& motion, ConstVectors x_t0, ConstVectors x_t1);

  /// The same with an individual contact radius for each point [m], finite and at least 0. Radii may change from step to step; a point that grows into
  /// the surface is relocated to its new radius.
  std::vector<Contact> detect(const Motion& motion, ConstVectors x_t0, ConstVectors x_t1, const Numbers& radius);

  /// On longer paths the rounding error of coordinates grows until contact is missed.
  static constexpr double longest_path = 1e6;

  /// Reports that something else displaced the point since the last step (a periodic boundary, another wall).
  void moved(std::size_t point) { swept_.moved(point); }

  /// Reports that points were renumbered, or many displaced: all are evaluated again in the next step. Information on single points is lost.
  /// If the contact bounds clip or the surface is open, points that start the next step inside, by more than their path length in it, are
  /// regarded as having entered outside the contact bounds (Swept::renumbered).
  void points_changed();

  /// The points that are inside the surface, or nearer than the contact radius, for a check before the first step. Contact alone is not
  /// inside. Throws as detect() does.
  std::vector<std::size_t> points_inside(const Pose& pose, ConstVectors x) const;
  /// The same with an individual contact radius for each point [m].
  std::vector<std::size_t> points_inside(const Pose& pose, ConstVectors x, const Numbers& radius) const;

  /// The state between two steps, besides positions and poses, for a restart. A detector of the same surface, radius and contact bounds that
  /// resumes it continues bitwise identically. The numbers are point numbers. Individual radii are not part of it: with an open surface, a point
  /// whose radius grows between the step before and the first one after is taken for one that came round its boundary.
  struct State {
    std::vector<std::uint64_t> inside;      ///< entered outside the contact bounds, or round the boundary of an open surface
    std::vector<std::uint64_t> in_contact;  ///< in contact with an open surface in the last step
    std::uint64_t entered = 0;              ///< number of entries so far
    std::uint64_t renumbered = 0;           ///< 1 after points_changed()
  };
  State state() const;  ///< between two steps
  /// Throws InputError if a list is not in ascending order.
  void resume(const State& state);

  /// The underlying detector: surface, contact radius, effort so far, points that entered outside the contact bounds.
  const Swept& swept() const { return swept_; }

 private:
  double offset_of(ConstVectors x, const Motion& motion);
  double note_radii(const Numbers& radius, std::size_t points, double offset);
  template <class P>
  std::vector<Contact> contacts_of(const P& points, const Motion& motion);

  Swept swept_;
  Vec3d centre_;                // [m] of the surface's bounds, in the body frame
  double reach_;                // [m] radius of the surface about that centre
  double longest_path_;         // [m]
  std::vector<double> travel_;  // [m] of each block in the current step
  Radii radii_;                 // of the previous step
};

}  // namespace fccda
