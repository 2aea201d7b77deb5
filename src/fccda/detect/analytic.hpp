/// Contact with a sphere or an infinite circular cylinder by the distance to its centre or axis (seed paper, section 2.2, eqs. 6 to 8):
/// the "original" peridynamic contact, and what meshes of those shapes converge to.
///
/// A point touches where it ends nearer to the centre or axis than R + r, and is put back at that distance, straight out from where it
/// ended. Two mends for long steps: where the path, straight in the frame of the body, ends beyond the centre, inside or right through,
/// the point is put where it first touched. A path that only grazes and ends outside on its own side is no contact.
///
/// A region bounds where the surface is felt. Nothing is remembered: a point that comes into the region inside the shape is struck.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "fccda/contact_bounds/all_contact_bounds.hpp"
#include "fccda/detect/contact.hpp"
#include "fccda/detect/every_point.hpp"
#include "fccda/detect/points.hpp"
#include "fccda/rigid_body/pose.hpp"

namespace fccda {

/// In the frame of the body.
struct Sphere {
  double radius = 0;  ///< [m]
  Vec3d centre{};     ///< [m]
  Vec3d from_centre(const Vec3d& point) const { return point - centre; }
};

struct InfiniteCylinder {
  double radius = 0;    ///< [m]
  Vec3d point{};        ///< [m] of the axis
  Vec3d axis{0, 0, 1};  ///< unit
  Vec3d from_centre(const Vec3d& place) const {
    const Vec3d line = place - point;
    return line - dot(line, axis) * axis;
  }
};

using AnalyticShape = std::variant<Sphere, InfiniteCylinder>;

class Analytic {
 public:
  static constexpr std::string_view name = "analytic";

  /// `radius`: contact radius [m].
  Analytic(const AnalyticShape& shape, const ContactBounds& region, double radius) : shape_(shape), region_(region), radius_(radius) {}

  /// Adds the contacts of one step to `out`, in point order. Asks every point; the travel of the surface is not needed.
  template <Points P>
  void detect(const P& points, const Motion& motion, double, std::vector<Contact>& out) {
    look_at_every_point(points, found_, [&](std::size_t i, Found& found) { look_at(i, points.position_t0(i), points.position_t1(i), motion, found); });
    gather(out);
  }

  /// As Swept answers it; looks at every point again.
  template <Points P>
  void redetect(const P& points, const Motion& motion, double surface_travel, double, std::vector<Contact>& out) {
    detect(points, motion, surface_travel, out);
  }

  /// The same for chosen points, in rising order, that somebody else displaced since.
  template <Points P>
  void detect_again(const P& points, const Motion& motion, double, std::span<const std::size_t> which, std::vector<Contact>& out) {
    look_at_points(which, found_, [&](std::size_t i, Found& found) { look_at(i, points.position_t0(i), points.position_t1(i), motion, found); });
    gather(out);
  }

  /// Those of the points that are nearer than R + r at t1, for all that was done.
  template <Points P>
  std::vector<std::size_t> still_inside(const P& points, const Motion& motion, std::span<const std::size_t> which) {
    std::vector<std::size_t> inside;
    for (const std::size_t i : which)
      if (is_inside(motion.t1.to_body(points.position_t1(i)))) inside.push_back(i);
    return inside;
  }

  void moved(std::size_t) {}  ///< nothing is remembered
  void forget() {}

  /// The points nearer than R + r at the poses of t0. Touching is not inside: 1e-9 R is allowed for.
  template <Points P>
  std::vector<std::size_t> initial_overlap(const P& points, const Pose& pose) const {
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points.occupied(i) && is_inside(pose.to_body(points.position_t0(i)))) inside.push_back(i);
    return inside;
  }

  /// Where such points belong [m], in the world: straight out from the centre or axis; nothing for one that is exactly there.
  std::vector<std::optional<Vec3d>> nearest_outside(std::span<const Vec3d> points, const Pose& pose) const;

  const Effort& effort() const { return effort_; }

  template <class Visitor>
  void visit_state(Visitor&&) {}
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    effort_.visit(visit);
  }

 private:
  struct Found {
    std::vector<Contact> contacts;
    Effort effort;
  };

  void gather(std::vector<Contact>& out) {
    for (const Found& found : found_) {
      out.insert(out.end(), found.contacts.begin(), found.contacts.end());
      effort_ += found.effort;
    }
  }
  double shape_radius() const {
    return std::visit([](const auto& shape) { return shape.radius; }, shape_);
  }
  Vec3d from_centre(const Vec3d& point) const {
    return std::visit([&](const auto& shape) { return shape.from_centre(point); }, shape_);
  }
  bool is_inside(const Vec3d& point) const;
  void look_at(std::size_t point, const Vec3d& position_t0, const Vec3d& position_t1, const Motion& motion, Found& found) const;

  AnalyticShape shape_;
  ContactBounds region_;
  double radius_;
  Effort effort_;
  std::vector<Found> found_;  // of each block
};

}  // namespace fccda
