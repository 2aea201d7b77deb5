/// Contact with a surface whose vertices move, as plain function calls: positions of points and vertices in, contacts and impulses on
/// vertices out. This is the detector of deforming/deforming.hpp over arrays.
///
///   const auto hull = std::make_shared<DeformingSurface>(Surface(panels));
///   DeformingContactDetector detector(hull, 0.01);
///   while (...) {
///     hull->move(vertices);                                                    // at the end of the step: of a finite-element solver, for example
///     ...                                                                      // x_t1 of the points
///     const std::vector<DeformingContact> contacts = detector.detect(x_t0, x_t1);
///     respond(contacts, dt, {x_t0, x_t1, velocity, mass}, friction, vertex_mass, vertex_impulses);
///   }
///
/// Any number of detectors may share one surface; it is moved once in each step.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "fccda/api/contact_detector.hpp"
#include "fccda/api/radii.hpp"
#include "fccda/api/respond_arrays.hpp"
#include "fccda/api/vectors.hpp"
#include "fccda/deforming/deforming.hpp"
#include "fccda/deforming/respond.hpp"

namespace fccda {

/// A detector of contact of one set of points with a deforming surface. It caches each point's distance from the surface.
class DeformingContactDetector {
 public:
  /// `radius` [m]: contact radius of points, 0 for points without extent; overridden by radii passed to detect(). Throws InputError if it is negative or not
  /// finite.
  explicit DeformingContactDetector(std::shared_ptr<const DeformingSurface> surface, double radius = 0) : detector_(std::move(surface), radius) {}

  /// The contacts of the step that the surface has begun, in point order, bitwise identical for any number of threads. x_t0 and x_t1 [m]: positions
  /// at the two ends of the step; x_t0 must equal x_t1 of the previous step after relocation. Points may be appended or removed, and steps repeated, as with
  /// ContactDetector; the surface is then placed where the step begins (DeformingSurface::place). Throws InputError if they differ in number, or the surface
  /// was not moved since the last detection. Throws RunError if a position is not finite, or a point moves farther than ContactDetector::longest_path sizes of
  /// the surface. Positions in single precision: as ContactDetector::detect.
  std::vector<DeformingContact> detect(ConstVectors x_t0, ConstVectors x_t1);

  /// The same with an individual contact radius for each point [m], finite and at least 0. Radii may change from step to step.
  std::vector<DeformingContact> detect(ConstVectors x_t0, ConstVectors x_t1, const Numbers& radius);

  void moved(std::size_t point) { detector_.moved(point); }  ///< reports that something else displaced the point since the last step
  void points_changed();                                     ///< reports that points were renumbered, or many displaced

  /// The points that are inside the surface where it is now, or nearer than the contact radius, for a check before the first step.
  std::vector<std::size_t> points_inside(ConstVectors x) const;
  /// The same with an individual contact radius for each point [m].
  std::vector<std::size_t> points_inside(ConstVectors x, const Numbers& radius) const;

  ContactDetector::State state() const;              ///< between two steps, besides positions, for a restart; see ContactDetector::State
  void resume(const ContactDetector::State& state);  ///< throws InputError if a list is not in ascending order

  const Deforming& detector() const { return detector_; }  ///< the underlying detector

 private:
  double measure(ConstVectors x_t0, ConstVectors x_t1, double radius);

  Deforming detector_;
  std::vector<double> travel_;  // [m] of each block in the current step
  Radii radii_;                 // of the previous step
};

/// Modifies the points in contact, and adds the impulses on the surface to `vertex_impulses` [N s], one for each vertex of its panels. Returns their sum,
/// with moments about the origin. `vertex_mass` [kg]: one for all vertices or one for each; infinite: its motion is prescribed. Throws InputError if arrays
/// differ in length, contacts are not in ascending order of their points, dt or a mass of a vertex is not positive, or a mass, impulse or the
/// friction is negative or not finite; RunError if the velocity or position of a point is not finite. Nothing is changed then.
ContactSum respond(std::span<const DeformingContact> contacts, double dt, const PointArrays& points, double friction, const Numbers& vertex_mass,
                   Vectors vertex_impulses);

/// The mass of vertices whose motion is prescribed [kg].
inline constexpr double prescribed_motion = std::numeric_limits<double>::infinity();

}  // namespace fccda
