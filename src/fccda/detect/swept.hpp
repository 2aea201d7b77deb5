/// The swept detector: finds every crossing, for any shape and orientation, and skips most points (continuous collision detection).
///
/// path_test.hpp defines contact and relocation; distance_cache.hpp selects the points to evaluate. Points are processed in blocks, in
/// parallel; contacts are in point order and independent of the number of threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/parallel_throwing.hpp"
#include "fccda/detect/contact.hpp"
#include "fccda/detect/curved_path.hpp"
#include "fccda/detect/distance_cache.hpp"
#include "fccda/detect/every_point.hpp"
#include "fccda/detect/found.hpp"
#include "fccda/detect/nearest_outside.hpp"
#include "fccda/detect/path_test.hpp"
#include "fccda/detect/points.hpp"
#include "fccda/detect/side_record.hpp"
#include "fccda/rigid_body/pose.hpp"

namespace fccda {

/// The swept detector: continuous collision detection of points or balls with a moving surface.
class Swept final : public SlidingSurface {
 public:
  static constexpr std::string_view name = "swept";  ///< its name in a deck

  /// `radius`: contact radius [m] of points without an individual one (points.hpp), 0 for points without extent.
  Swept(SharedSurface surface, const ContactBounds& region, double radius) : test_(std::move(surface), region, radius) {}
  /// With search structures of its own.
  Swept(std::shared_ptr<const Surface> surface, const ContactBounds& region, double radius) : Swept(share(std::move(surface)), region, radius) {}

  /// Relative rounding of the stored coordinates of relocated points, if above that of doubles (2^-24 for floats): relocated points keep a
  /// correspondingly larger distance from the surface, the offset. It must be small against the contact radius: the plain calls refuse more than a tenth.
  void set_rounding(double of_coordinates) { rounding_ = of_coordinates; }

  /// [m] what relocation adds to the contact radius, and the contact test subtracts from it, in a step of this motion.
  double offset(const Motion& motion) const;

  /// Adds the contacts of one step to `out`, in point order. `surface_travel` [m]: bound of the displacement of any point of the surface in
  /// this step, for both arc and chord (RigidBody::travel_bound). Throws InputError if the motion is not finite. A point with a path that is
  /// not finite is skipped.
  template <Points P>
  void detect(const P& points, const Motion& motion, double surface_travel, std::vector<Contact>& out) {
    begin(points, motion);
    const BodyView view(motion, test_.size());
    due_blocks_.clear();
    for (std::size_t b = 0; b < points.block_count(); ++b)
      if (cache_.travel(b, step_.approach(points.block_travel(b) + surface_travel))) due_blocks_.push_back(b);
    fetch_points(points, due_blocks_, [&](std::size_t b, std::size_t i) { return cache_.is_due(b, i); });
    if (found_.size() < due_blocks_.size()) found_.resize(due_blocks_.size());
    parallel_for_uneven_throwing(static_cast<std::ptrdiff_t>(due_blocks_.size()),
                                 [&](std::ptrdiff_t k) { evaluate_block(points, view, surface_travel, static_cast<std::size_t>(k), 0); });
    gather(due_blocks_.size(), out);
    sides_.end();
  }

  /// Repeats the last detection with another pose of the body at the end of the step: no point of the surface is farther than `correction` [m]
  /// from its previous position there. The points are unchanged, or were reported as `moved`. Finds what `detect` would have found with this
  /// motion; only points that are near are evaluated.
  template <Points P>
  void redetect(const P& points, const Motion& motion, double surface_travel, double correction, std::vector<Contact>& out) {
    begin_again(largest_radius_of(points), motion);
    const BodyView view(motion, test_.size());
    due_blocks_.clear();
    // A path that came near and went away may now be in contact, so all points with less clearance than their path length are due.
    for (std::size_t b = 0; b < points.block_count(); ++b) {
      cache_.travel(b, correction);
      if (cache_.is_near(b, way(points, b, surface_travel))) due_blocks_.push_back(b);
    }
    fetch_points(points, due_blocks_, [&](std::size_t b, std::size_t i) { return cache_.is_due(b, i, way(points, b, surface_travel)); });
    if (found_.size() < due_blocks_.size()) found_.resize(due_blocks_.size());
    parallel_for_uneven_throwing(static_cast<std::ptrdiff_t>(due_blocks_.size()), [&](std::ptrdiff_t k) {
      const auto block = static_cast<std::size_t>(k);
      evaluate_block(points, view, surface_travel, block, way(points, due_blocks_[block], surface_travel));
    });
    gather(due_blocks_.size(), out);
    sides_.end();
  }

  /// The same as `detect` for selected points, in ascending order, that were displaced after `detect` in this step: their paths lead from
  /// their positions at t0 to their current ones.
  template <Points P>
  void detect_again(const P& points, const Motion& motion, double surface_travel, std::span<const std::size_t> which, std::vector<Contact>& out) {
    const BodyView view(motion, test_.size());
    evaluate_points(which, found_, [&](std::size_t i, Found& found) {
      const std::size_t block = cache_.block_of(i);
      evaluate(block, i, contact_radius(points, i, test_.radius()), points.position_t0(i), points.position_t1(i), view,
               look_ahead(points.block_travel(block) + surface_travel), found);
    });
    for (const std::size_t i : which) cache_.update_point(i);
    gather(found_.size(), out);
  }

  /// For a contact of this step.
  Vec3d slide(const Pose& pose, const Vec3d& from, const Vec3d& to, double radius) const override;

  /// Those of the points, in ascending order, that are inside at t1, or nearer than the contact radius, in spite of the response. Points that
  /// entered where contact is ignored do not count.
  template <Points P>
  std::vector<std::size_t> still_inside(const P& points, const Motion& motion, std::span<const std::size_t> which) const {
    return fccda::still_inside(test_, points, motion.t1, which, [&](std::size_t i) { return sides_.has_entered(i); });
  }

  /// Reports that point i was displaced after the last detection.
  void moved(std::size_t i) { cache_.forget(i); }

  /// Reports that the radius of point i is larger than in the last detection. If it starts the next step inside, it counts as pushed there.
  void grown(std::size_t i);

  /// Discards the cached distances. Does not change contacts, as long as points keep their numbers.
  void forget();

  /// Reports a renumbering of points other than appending or removing some at the end. The record of points that had entered, or were pinched
  /// against an open surface, is lost with the numbers. So if the surface can be entered (clipping contact bounds, an open surface), points
  /// that start the next step inside, by more than their path length in it, are regarded as entered, and not counted again.
  void renumbered();

  /// The points whose centre is inside the surface, or nearer to it than the contact radius, at t0 of the coming step; for an open surface, in
  /// front of it. Contact alone is not inside.
  template <Points P>
  std::vector<std::size_t> initial_overlap(const P& points, const Pose& pose) const {
    return fccda::initial_overlap(test_, points, pose);
  }

  /// Relocated positions of such points [m], at the detector's contact radius, in the world frame; nothing if no position is clear of the surface.
  std::vector<std::optional<Vec3d>> nearest_outside(std::span<const Vec3d> points, const Pose& pose) const {
    return fccda::nearest_outside(test_, points, pose);
  }

  /// The number of points that entered where contact is ignored (beyond clipping contact bounds, round the boundary of an open surface). They
  /// were not in contact.
  std::uint64_t entered_inside() const { return sides_.entered_count(); }

  const Effort& effort() const { return effort_; }                                ///< of all detections so far
  std::size_t buried_triangles() const { return test_.solids().buried_count(); }  ///< that may lie in another closed part, fully or partly
  const Surface& surface() const { return test_.surface(); }                      ///< in the body frame
  double radius() const { return test_.radius(); }                                ///< [m] of points without an individual one

  /// Calls visit(name, list of numbers) for the state that the next step depends on; the visitor may write. Cached distances are not state.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    SideRecord::visit_state(sides_, visit);
  }
  /// The same for reading.
  template <class Visitor>
  void visit_state(Visitor&& visit) const {
    SideRecord::visit_state(sides_, visit);
  }

  /// The same for counts, some of which depend on the cached distances.
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    effort_.visit(visit);
    sides_.visit_record(visit);
  }

 private:
  /// Distances are searched this many steps ahead: most points found are then not evaluated again for as long.
  static constexpr double look_ahead_factor = 64;

  /// Parameters of the motion of this step.
  struct Step {
    double offset = 0;     // [m] of relocated points
    double stretch = 1;    // of distances travelled
    double allowance = 0;  // [m]
    double approach(double travel) const { return stretch * travel + allowance; }
  };

  using Found = fccda::Found<Contact>;

  template <Points P>
  void begin(const P& points, const Motion& motion) {
    list_blocks(points, blocks_);
    if (cache_.differs_from(blocks_)) {
      cache_.start(blocks_);
      guess_.assign(points.size(), -1);
    }
    begin_step(points.size(), largest_radius_of(points), motion);
  }

  template <Points P>
  double largest_radius_of(const P& points) const {
    if constexpr (PointsOfOwnRadius<P>) return points.largest_radius();
    return test_.radius();
  }

  template <Points P>
  double way(const P& points, std::size_t block, double surface_travel) const {
    return step_.approach(points.block_travel(block) + surface_travel);
  }

  /// `near` [m]: points are evaluated that are due, or would be after this much more travel.
  template <Points P>
  void evaluate_block(const P& points, const BodyView& view, double surface_travel, std::size_t k, double near) {
    const std::size_t b = due_blocks_[k];
    Found& found = found_[k];
    found.clear();
    const double ahead = look_ahead(points.block_travel(b) + surface_travel);
    for (std::size_t i = points.block_begin(b); i < points.block_end(b); ++i) {
      if (!cache_.is_due(b, i, near)) continue;
      if (points.occupied(i))
        evaluate(b, i, contact_radius(points, i, test_.radius()), points.position_t0(i), points.position_t1(i), view, ahead, found);
      else
        cache_.postpone(b, i, Bvh::no_cap);
    }
    cache_.update_block(b);
  }

  // Without a limit where the travel of a block is not a number: a search up to that finds nothing, also for the other points of the block.
  double look_ahead(double travel) const {
    const double ahead = look_ahead_factor * step_.approach(travel);
    return ahead >= 0 ? ahead : Bvh::no_cap;
  }
  void begin_step(std::size_t point_count, double largest_radius, const Motion& motion);
  void begin_again(double largest_radius, const Motion& motion);
  void measure(double largest_radius, const Motion& motion);
  void evaluate(std::size_t block, std::size_t point, double radius, const Vec3d& position_t0, const Vec3d& position_t1, const BodyView& view,
                double look_ahead, Found& found);
  void gather(std::size_t shares, std::vector<Contact>& out);

  PathTest test_;
  double rounding_ = 0;  // of coordinates, relative
  Step step_;
  SideRecord sides_;

  Effort effort_;

  DistanceCache cache_;     // caches from here on
  Pose pose_;               // at the end of the last detection; the cached distances refer to it
  std::vector<int> guess_;  // the triangle last found near each point
  std::vector<std::size_t> blocks_, due_blocks_;
  std::vector<Found> found_;  // of each due block or, again, of each 64 points
};

}  // namespace fccda
