/// Detection as a plain call: positions before and after a step in, contacts out. It is the swept detector (detect/swept.hpp) over
/// arrays; a solver with blocks and bounds of its own calls that one through the Points interface (detect/points.hpp) instead.
///
///   ContactDetector detector{Surface(read_panels("hull.stl")), {.radius = 0.01}};
///   while (...) {
///     const Motion motion = hull.advance(dt);                                     // RigidBody, or any two poses
///     ...                                                                         // x_t1 of the solver
///     const std::vector<Contact> contacts = detector.detect(motion, x_t0, x_t1);
///     respond(contacts, motion, hull, {x_t0, x_t1, velocity, mass});              // plain/respond_arrays.hpp
///   }
///
/// Several detectors of one surface share it, and what searches on it need (search/indexed_surface.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "fccda/api/vectors.hpp"
#include "fccda/detect/swept.hpp"

namespace fccda {

/// One detector follows one set of points: it remembers how far each was from the surface, so that most are not looked at.
class ContactDetector {
 public:
  struct Options {
    double radius = 0;  ///< [m] contact radius: points are balls; 0 for points without extent. Points that detect() is given radii of have those
    ContactBounds region = Unbounded();  ///< where contact is looked for, in the body frame
  };

  /// Throws InputError where the radius is negative or no number.
  ContactDetector(SharedSurface surface, const Options& options);
  explicit ContactDetector(SharedSurface surface) : ContactDetector(std::move(surface), Options{}) {}
  ContactDetector(Surface surface, const Options& options) : ContactDetector(share(std::move(surface)), options) {}
  explicit ContactDetector(Surface surface) : ContactDetector(std::move(surface), Options{}) {}

  /// The contacts of one step, in point order, the same for any number of threads. x_t0 and x_t1: positions in the world frame at the
  /// two ends of the step [m]. x_t0 must be x_t1 of the step before, as relocated; for points of which that is not true see below.
  /// motion.t0 is motion.t1 of the step before; a body that was put elsewhere in between has all points looked at again.
  /// Points may be appended or taken off the end between steps, but not both between the same two. Throws InputError where there are not as many x_t1 as x_t0
  /// or the motion is not finite, RunError where a position is not, or a point goes further in the step than `longest_way` sizes of the surface.
  ///
  /// Positions in single precision are relocated to 2.4e-7 of the largest coordinate from the surface, so that rounding puts none into it.
  std::vector<Contact> detect(const Motion& motion, ConstVectors x_t0, ConstVectors x_t1);

  /// The same where each point has a contact radius of its own [m], finite and at least 0. They may change from step to step.
  std::vector<Contact> detect(const Motion& motion, ConstVectors x_t0, ConstVectors x_t1, const Numbers& radius);

  /// On longer ways rounding of their coordinates grows, until a point is not struck where it should be.
  static constexpr double longest_path = 1e6;

  /// Somebody else displaced the point since the last step (a periodic boundary, another wall).
  void moved(std::size_t point) { swept_.moved(point); }

  /// Points were renumbered, or many displaced: all are looked at again in the next step. What was known of single points is lost: where
  /// the region clips or the surface is open, those that start the next step inside, by more than their way in it, are taken as such that
  /// came in where the surface is not felt (Swept::renumbered).
  void points_changed() { swept_.renumbered(); }

  /// The points that are inside the surface, or nearer than the contact radius: to be asked before the first step. Touching is not inside.
  /// Throws as detect() does.
  std::vector<std::size_t> points_inside(const Pose& pose, ConstVectors x) const;
  std::vector<std::size_t> points_inside(const Pose& pose, ConstVectors x, const Numbers& radius) const;

  /// What the next step depends on beside positions and poses, between two steps: for a restart. A detector of the same surface, radius and
  /// region that resumes it goes on to the bit. Numbers are those of points.
  struct State {
    std::vector<std::uint64_t> inside;   ///< came in where the surface is not felt (a clipping region, round the rim of an open surface)
    std::vector<std::uint64_t> touched;  ///< in contact with an open surface in the last step
    std::uint64_t entered = 0;           ///< how many ever came in
    std::uint64_t renumbered = 0;        ///< 1 after points_changed()
  };
  State state() const;
  /// Throws InputError where a list is not in rising order.
  void resume(const State& state);

  /// What is behind it: surface, contact radius, work done so far, points that came in where the surface is not felt.
  const Swept& swept() const { return swept_; }

 private:
  void measure_paths(ConstVectors x_t0, ConstVectors x_t1);
  double note_radii(const Numbers& radius, std::size_t points);
  template <class P>
  std::vector<Contact> contacts_of(const P& points, const Motion& motion);

  Swept swept_;
  Vec3d centre_;                // [m] of the surface's bounds, in the body frame
  double reach_;                // [m] no point of the surface is further from there
  double longest_path_;         // [m]
  std::vector<double> travel_;  // [m] of each block in the present step
  std::vector<double> radius_;  // [m] of each point in the step before, where they had radii of their own
};

}  // namespace fccda
