/// The detector of Zhang et al. (sections 3.1 to 3.3): for each point in the bounding box, a loop over all panels, each regarded as an infinite
/// plane. It is the reference for the other detectors and the baseline of the benchmarks; every missed crossing is attributed to the equation
/// that rejected it. Quads stay quads, panels are transformed to the world frame, the contact radius is 0.
///
/// `literal`: the equations as printed, with misprints of dimension corrected (unit normals in eq. 18; x_pen there read as the point; its sign
/// such that the point moves to the plane and not away from it). x^t is compared with the plane at t and x^{t+Δt} with the plane at t+Δt,
/// since otherwise a point at rest is never in contact.
///   eq. 14  the y and z of x^t lie within those of the panel's nodes at t. A panel normal to y or z has no such range.
///   eq. 15  the projection of x^t on the x–y plane lies within that of the panel, by the sum of areas, to 1e-9 of the panel's area.
///           For a panel parallel to z that area is 0, and only points exactly on its line pass: for a cylinder with its axis along z
///           the literal variant finds no contact at all on the lateral surface.
///   eq. 17  the point changes sides, in either direction.
///   eq. 20  A x^t + B y^t + C z^t + D <= 0 if the point is not above the origin of the body, >= 0 if it is. With normals
///           outward, as in the paper, this rejects every contact from below.
/// So the plate of the paper (section 5) cannot be computed by the literal variant.
///
/// `corrected`: the variant that can.
///   eq. 14  in x, y and z; the ranges swept by the point and by the panel from t to t+Δt must overlap.
///   eq. 15  at t+Δt, projected along the largest component of the normal, that is, on the plane of the two smaller ones.
///   eq. 17  from outside to inside only.
///   eq. 18  clamped to the panel, and 1e-12 of the surface's size off it: of points placed exactly on a plane, rounding has half
///           inside in the next step, and those would never be in contact again.
///   eq. 20  omitted: with outward normals the sign is the same everywhere.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/contract.hpp"
#include "fccda/contact_bounds/all_contact_bounds.hpp"
#include "fccda/detect/contact.hpp"
#include "fccda/detect/every_point.hpp"
#include "fccda/detect/nearest_outside.hpp"
#include "fccda/detect/path_test.hpp"
#include "fccda/detect/points.hpp"
#include "fccda/rigid_body/pose.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// The verdict of the equations on a point's step and a panel: accepted, or the first equation that rejected it.
enum class Verdict { accepted, eq14, eq15, eq17, eq20 };

/// The number of pairs of point and panel rejected by each equation; a pair counts at the first one.
struct Rejections {
  std::size_t by_eq14 = 0, by_eq15 = 0, by_eq17 = 0, by_eq20 = 0;

  void count(Verdict verdict);
  Rejections& operator+=(const Rejections& b) {
    by_eq14 += b.by_eq14, by_eq15 += b.by_eq15, by_eq17 += b.by_eq17, by_eq20 += b.by_eq20;
    return *this;
  }
};

class Published {
 public:
  static constexpr std::string_view name = "published";
  enum class Variant { corrected, literal };

  Published(std::shared_ptr<const Surface> surface, const ContactBounds& region, Variant variant);

  /// Adds the contacts of one step to `out`, in point order. The travel of the surface is not needed.
  template <Points P>
  void detect(const P& points, const Motion& motion, double, std::vector<Contact>& out) {
    place(motion);
    evaluate_every_point(points, found_, [&](std::size_t i, Found& found) { evaluate(i, points.position_t0(i), points.position_t1(i), motion, found); });
    gather(out);
  }

  /// As Swept::redetect, but evaluates every point again.
  template <Points P>
  void redetect(const P& points, const Motion& motion, double surface_travel, double, std::vector<Contact>& out) {
    detect(points, motion, surface_travel, out);
  }

  /// The same for selected points, in ascending order, that were displaced after `detect` in this step.
  template <Points P>
  void detect_again(const P& points, const Motion& motion, double, std::span<const std::size_t> which, std::vector<Contact>& out) {
    evaluate_points(which, found_, [&](std::size_t i, Found& found) { evaluate(i, points.position_t0(i), points.position_t1(i), motion, found); });
    gather(out);
  }

  /// As Swept::still_inside, for points without extent.
  template <Points P>
  std::vector<std::size_t> still_inside(const P& points, const Motion& motion, std::span<const std::size_t> which) const {
    return fccda::still_inside(*sides_, points, motion.t1, which, [](std::size_t) { return false; });
  }

  void moved(std::size_t) {}  ///< stateless
  void forget() {}

  /// As Swept::initial_overlap, for points without extent.
  template <Points P>
  std::vector<std::size_t> initial_overlap(const P& points, const Pose& pose) const {
    return fccda::initial_overlap(*sides_, points, pose);
  }

  /// As Swept::nearest_outside, for points without extent.
  std::vector<std::optional<Vec3d>> nearest_outside(std::span<const Vec3d> points, const Pose& pose) const {
    return fccda::nearest_outside(*sides_, points, pose);
  }

  const Effort& effort() const { return effort_; }
  const Rejections& rejections() const { return rejections_; }  ///< of all detections so far

  /// Why the step from x_t0 to x_t1 [m] was accepted or rejected as contact with a panel of the surface, numbered as in the file: for a panel
  /// that was actually crossed, the reason of the miss.
  Verdict verdict(std::size_t panel, const Vec3d& x_t0, const Vec3d& x_t1, const Motion& motion) const {
    EXPECTS(panel < sign_.size() && sign_[panel] != 0);
    return judge({plane(panel, motion.t0), plane(panel, motion.t1)}, x_t0, x_t1, motion);
  }

  template <class Visitor>
  void visit_state(Visitor&&) {}
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    effort_.visit(visit);
    visit("rejected_by_eq14", rejections_.by_eq14);
    visit("rejected_by_eq15", rejections_.by_eq15);
    visit("rejected_by_eq17", rejections_.by_eq17);
    visit("rejected_by_eq20", rejections_.by_eq20);
  }

 private:
  /// A panel in the world frame at one time: A x + B y + C z + D = 0 with unit (A, B, C).
  struct Plane {
    std::array<Vec3d, 4> node{};
    std::size_t nodes = 0;  // 3 or 4; 0 for a panel that the surface dropped
    Vec3d normal{};
    double d = 0;
    Box box;
    double height(const Vec3d& point) const { return dot(normal, point) + d; }
  };

  /// The same panel at the two ends of the step.
  struct Planes {
    const Plane &before, &after;
  };

  struct Found {
    std::vector<Contact> contacts;
    Effort effort;
    Rejections rejections;
  };

  void gather(std::vector<Contact>& out) {
    for (const Found& found : found_) {
      out.insert(out.end(), found.contacts.begin(), found.contacts.end());
      effort_ += found.effort;
      rejections_ += found.rejections;
    }
  }
  void place(const Motion& motion);
  Plane plane(std::size_t panel, const Pose& pose) const;
  void evaluate(std::size_t point, const Vec3d& x_t0, const Vec3d& x_t1, const Motion& motion, Found& found) const;
  Verdict judge(const Planes& panel, const Vec3d& x_t0, const Vec3d& x_t1, const Motion& motion) const {
    return variant_ == Variant::literal ? judge_literal(panel, x_t0, x_t1, motion) : judge_corrected(panel, x_t0, x_t1);
  }
  static Verdict judge_literal(const Planes& panel, const Vec3d& x_t0, const Vec3d& x_t1, const Motion& motion);
  static Verdict judge_corrected(const Planes& panel, const Vec3d& x_t0, const Vec3d& x_t1);
  Vec3d relocated(const Plane& plane, const Vec3d& x_t1) const;

  std::shared_ptr<const Surface> surface_;
  ContactBounds region_;
  Variant variant_;
  std::vector<int> sign_;             // of each panel's normal as given: -1 if the surface was flipped outward, 0 if the panel was dropped
  std::vector<Plane> at_t0_, at_t1_;  // of this step
  Effort effort_;
  Rejections rejections_;
  std::vector<Found> found_;               // of each block
  std::shared_ptr<const PathTest> sides_;  // for inside tests
};

}  // namespace fccda
