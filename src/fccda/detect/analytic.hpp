/// Contact with a sphere or an infinite circular cylinder by the distance to its centre or axis (Zhang et al., section 2.2, eqs. 6 to 8): the
/// "original" peridynamic contact, and the limit of meshes of those shapes.
///
/// A point is in contact if it ends nearer to the centre or axis than R + r. It is relocated to that distance, radially outward from its end.
/// Two corrections apply to long steps. If the path, straight in the body frame, ends beyond the centre, inside or right through, the point
/// is relocated to its position of first contact. A path that only grazes and ends outside on its own side is not in contact.
///
/// Contact bounds limit where contact counts. The detector is stateless: a point that enters the bounds inside the shape is in contact.
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

/// In the body frame.
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

  /// Adds the contacts of one step to `out`, in point order. Evaluates every point; the travel of the surface is not needed.
  template <Points P>
  void detect(const P& points, const Motion& motion, double, std::vector<Contact>& out) {
    evaluate_every_point(points, found_, [&](std::size_t i, Found& found) { evaluate(i, points.position_t0(i), points.position_t1(i), motion, found); });
    gather(out);
  }

  /// As Swept::redetect, but evaluates every point again.
  template <Points P>
  void redetect(const P& points, const Motion& motion, double surface_travel, double, std::vector<Contact>& out) {
    detect(points, motion, surface_travel, out);
  }

  /// The same for selected points, in ascending order, that were displaced since.
  template <Points P>
  void detect_again(const P& points, const Motion& motion, double, std::span<const std::size_t> which, std::vector<Contact>& out) {
    evaluate_points(which, found_, [&](std::size_t i, Found& found) { evaluate(i, points.position_t0(i), points.position_t1(i), motion, found); });
    gather(out);
  }

  /// Those of the points that are nearer than R + r at t1 in spite of the response.
  template <Points P>
  std::vector<std::size_t> still_inside(const P& points, const Motion& motion, std::span<const std::size_t> which) {
    std::vector<std::size_t> inside;
    for (const std::size_t i : which)
      if (is_inside(motion.t1.to_body(points.position_t1(i)))) inside.push_back(i);
    return inside;
  }

  void moved(std::size_t) {}  ///< stateless
  void forget() {}

  /// The points nearer than R + r at the poses of t0. Contact alone is not inside, within a tolerance of 1e-9 R.
  template <Points P>
  std::vector<std::size_t> initial_overlap(const P& points, const Pose& pose) const {
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points.occupied(i) && is_inside(pose.to_body(points.position_t0(i)))) inside.push_back(i);
    return inside;
  }

  /// Relocated positions of such points [m], in the world frame: radially outward; nothing for one exactly at the centre or on the axis.
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
  void evaluate(std::size_t point, const Vec3d& position_t0, const Vec3d& position_t1, const Motion& motion, Found& found) const;

  AnalyticShape shape_;
  ContactBounds region_;
  double radius_;
  Effort effort_;
  std::vector<Found> found_;  // of each block
};

}  // namespace fccda
