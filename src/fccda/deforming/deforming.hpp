/// The detector for deforming surfaces: finds every crossing, and skips most points (continuous collision detection).
///
///   surface->move(vertices);                  // of the coming step: once in each step, even at rest
///   detector.detect(points, contacts);
///   respond(points, contacts, dt, …);         // deforming/respond.hpp: relocation, velocities, impulses on vertices
///
/// moving_path_test.hpp defines contact and relocation; distance_cache.hpp selects the points to evaluate: a point is skipped until its block
/// and the fastest vertex together may have used up its distance. Points are processed in blocks, in parallel; contacts are in point order and
/// independent of the number of threads.
///
/// Any number of detectors, of several bodies, may share one surface.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/parallel_throwing.hpp"
#include "fccda/deforming/deforming_surface.hpp"
#include "fccda/deforming/moving_path_test.hpp"
#include "fccda/detect/contact.hpp"
#include "fccda/detect/distance_cache.hpp"
#include "fccda/detect/every_point.hpp"
#include "fccda/detect/found.hpp"
#include "fccda/detect/points.hpp"
#include "fccda/detect/side_record.hpp"

namespace fccda {

/// The place of a triangle that a contact acts on.
struct PanelPlace {
  std::array<int, 3> vertices{};    ///< its corners, numbered as the vertices of the panels that the surface was made of
  std::array<double, 3> weights{};  ///< barycentric coordinates, at least 0 and of sum 1
  Corners corners{};                ///< [m] at t1
  Vec3d displacement{};             ///< [m] of this place of the surface in the step
};

/// Contact of one point with a deforming surface.
struct DeformingContact {
  Contact contact;   ///< in the world frame
  PanelPlace place;  ///< the surface's point closest to the relocated position
};

/// The swept detector for a surface whose vertices move.
class Deforming final : public SlidingSurface {
 public:
  /// `radius`: contact radius [m] of points without an individual one (points.hpp), 0 for points without extent.
  Deforming(std::shared_ptr<const DeformingSurface> surface, double radius);

  /// Relative rounding of the stored coordinates of relocated points, as Swept::set_rounding.
  void set_rounding(double of_coordinates) { rounding_ = of_coordinates; }

  /// [m] as Swept::offset, in the step that the surface has begun.
  double offset() const;

  /// Adds the contacts of the step that the surface has begun to `out`, in point order. Throws InputError if the surface was not moved since the
  /// last detection. A point with a path that is not finite is skipped.
  template <Points P>
  void detect(const P& points, std::vector<DeformingContact>& out) {
    begin(points);
    const MovingPathTest test(*surface_);
    due_blocks_.clear();
    for (std::size_t b = 0; b < points.block_count(); ++b)
      if (cache_.travel(b, points.block_travel(b) + surface_->travel())) due_blocks_.push_back(b);
    fetch_points(points, due_blocks_, [&](std::size_t b, std::size_t i) { return cache_.is_due(b, i); });
    if (found_.size() < due_blocks_.size()) found_.resize(due_blocks_.size());
    parallel_for_uneven_throwing(static_cast<std::ptrdiff_t>(due_blocks_.size()),
                                 [&](std::ptrdiff_t k) { evaluate_block(points, test, static_cast<std::size_t>(k), 0); });
    gather(due_blocks_.size(), out);
    sides_.end();
  }

  /// Repeats the last detection after DeformingSurface::move_again(): no vertex is farther than `correction` [m] from its previous position at t1.
  /// The points are unchanged, or were reported as `moved`. Finds what `detect` would have found; only points that are near are evaluated.
  template <Points P>
  void redetect(const P& points, double correction, std::vector<DeformingContact>& out) {
    begin_again();
    const MovingPathTest test(*surface_);
    const auto way = [&](std::size_t b) { return points.block_travel(b) + surface_->travel(); };
    due_blocks_.clear();
    // A path that came near and went away may now be in contact, so all points with less clearance than their path length are due.
    for (std::size_t b = 0; b < points.block_count(); ++b) {
      cache_.travel(b, correction);
      if (cache_.is_near(b, way(b))) due_blocks_.push_back(b);
    }
    fetch_points(points, due_blocks_, [&](std::size_t b, std::size_t i) { return cache_.is_due(b, i, way(b)); });
    if (found_.size() < due_blocks_.size()) found_.resize(due_blocks_.size());
    parallel_for_uneven_throwing(static_cast<std::ptrdiff_t>(due_blocks_.size()), [&](std::ptrdiff_t k) {
      const auto share = static_cast<std::size_t>(k);
      evaluate_block(points, test, share, way(due_blocks_[share]));
    });
    gather(due_blocks_.size(), out);
    sides_.end();
  }

  /// The same for selected points, in ascending order, that were displaced after `detect` in this step.
  template <Points P>
  void detect_again(const P& points, std::span<const std::size_t> which, std::vector<DeformingContact>& out) {
    const MovingPathTest test(*surface_);
    evaluate_points(which, found_, [&](std::size_t i, Found& found) {
      const std::size_t block = cache_.block_of(i);
      evaluate(test, block, i, contact_radius(points, i, radius_), {points.position_t0(i), points.position_t1(i)}, look_ahead(points.block_travel(block)),
               found);
    });
    for (const std::size_t i : which) cache_.update_point(i);
    gather(found_.size(), out);
  }

  /// For a contact of this step. The pose is that of the world.
  Vec3d slide(const Pose& pose, const Vec3d& from, const Vec3d& to, double radius) const override;

  /// Those of the points, in ascending order, that are inside the surface at t1, or nearer than the contact radius, in spite of the response.
  /// Points that came round the boundary of an open surface do not count.
  template <Points P>
  std::vector<std::size_t> still_inside(const P& points, std::span<const std::size_t> which) const {
    std::vector<std::size_t> inside;
    for (const std::size_t i : which)
      if (is_inside(points.position_t1(i), contact_radius(points, i, radius_)) && !sides_.has_entered(i)) inside.push_back(i);
    return inside;
  }

  /// The points whose position at t0 is inside the surface where it is now (at t1 of its last step), or nearer than the contact radius; for an
  /// open surface, in front of it. For a check before the first step.
  template <Points P>
  std::vector<std::size_t> initial_overlap(const P& points) const {
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points.occupied(i) && is_inside(points.position_t0(i), contact_radius(points, i, radius_))) inside.push_back(i);
    return inside;
  }

  void moved(std::size_t i) { cache_.forget(i); }  ///< reports that point i was displaced after the last detection
  void grown(std::size_t i);                       ///< as Swept::grown
  void forget();                                   ///< discards the cached distances; does not change contacts, as long as points keep their numbers
  void renumbered();                               ///< reports a renumbering of points other than appending or removing some at the end

  /// The number of points that came round the boundary of an open surface. They were not in contact.
  std::uint64_t entered_inside() const { return sides_.entered_count(); }

  const Effort& effort() const { return effort_; }               ///< of all detections so far
  const DeformingSurface& surface() const { return *surface_; }  ///< that it detects contact with
  double radius() const { return radius_; }                      ///< [m] of points without an individual one

  /// Calls visit(name, list of numbers) for the state that the next step depends on, besides positions; the visitor may write.
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

  using Found = fccda::Found<DeformingContact>;

  template <Points P>
  void begin(const P& points) {
    list_blocks(points, blocks_);
    begin_step();
  }

  /// `near` [m]: points are evaluated that are due, or would be after this much more travel.
  template <Points P>
  void evaluate_block(const P& points, const MovingPathTest& test, std::size_t k, double near) {
    const std::size_t b = due_blocks_[k];
    Found& found = found_[k];
    found.clear();
    const double ahead = look_ahead(points.block_travel(b));
    for (std::size_t i = points.block_begin(b); i < points.block_end(b); ++i) {
      if (!cache_.is_due(b, i, near)) continue;
      if (points.occupied(i))
        evaluate(test, b, i, contact_radius(points, i, radius_), {points.position_t0(i), points.position_t1(i)}, ahead, found);
      else
        cache_.postpone(b, i, Bvh::no_cap);
    }
    cache_.update_block(b);
  }

  // Without a limit where the travel of a block is not a number, as Swept.
  double look_ahead(double travel) const {
    const double ahead = look_ahead_factor * (travel + surface_->travel());
    return ahead >= 0 ? ahead : Bvh::no_cap;
  }
  bool is_inside(const Vec3d& point, double radius) const;
  void begin_step();
  void begin_again();
  void evaluate(const MovingPathTest& test, std::size_t block, std::size_t point, double radius, const Path& path, double look_ahead, Found& found);
  void gather(std::size_t shares, std::vector<DeformingContact>& out);

  std::shared_ptr<const DeformingSurface> surface_;
  double radius_;
  double rounding_ = 0;     // of coordinates, relative
  double offset_ = 0;       // [m] of relocated points in this step
  std::uint64_t step_ = 0;  // the surface's step in the last detection
  SideRecord sides_;
  Effort effort_;

  DistanceCache cache_;     // caches from here on
  std::vector<int> guess_;  // the triangle last found near each point
  std::vector<std::size_t> blocks_, due_blocks_;
  std::vector<Found> found_;  // of each due block or, again, of each 64 points
};

}  // namespace fccda
