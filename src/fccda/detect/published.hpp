/// The seed paper's own detector (sections 3.1 to 3.3): for each point in the bounding box, a loop over all panels, each taken as an
/// infinite plane. It is the reference that others compare with and the baseline of the benchmarks; every crossing it misses is put down
/// to the equation that rejected it. Quads stay quads, panels are moved to the world frame, the contact radius is 0.
///
/// `letter`: the equations as printed, misprints of dimension mended (unit normals in eq. 18; x_pen there read as the point; its sign so
/// that the point goes to the plane and not away from it). x^t is compared with the plane at t and x^{t+Δt} with the plane at t+Δt, for
/// otherwise a point at rest is never struck.
///   eq. 14  the y and z of x^t lie within those of the panel's nodes at t. A panel normal to y or z has no such range.
///   eq. 15  the projection of x^t on the x–y plane lies within that of the panel, by the sum of areas, to 1e-9 of the panel's area.
///           For a panel parallel to z that area is 0, and only points exactly on its line pass: of a cylinder with its axis along z
///           the letter finds no contact at all on the lateral surface.
///   eq. 17  the point changes sides, in either direction.
///   eq. 20  A x^t + B y^t + C z^t + D <= 0 where the point is not above the origin of the body, >= 0 where it is. With normals
///           outward, as the paper has them, this refuses every contact from below.
/// So the paper's own plate (section 5) cannot run by the letter.
///
/// `repaired`: the reading under which it can.
///   eq. 14  in x, y and z; what the point passes from t to t+Δt and what the panel passes must have a range in common.
///   eq. 15  at t+Δt, projected along the largest component of the normal: on the plane of the two smaller ones.
///   eq. 17  from outside to inside only.
///   eq. 18  clamped to the panel, and 1e-12 of the surface's size off it: of the points put exactly on a plane, rounding has half
///           inside in the next step, and those would never be struck again.
///   eq. 20  left out: with outward normals the sign is the same everywhere.
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

/// What the equations say of a point's step and a panel: accepted, or the first equation that turned it down.
enum class Verdict { accepted, eq14, eq15, eq17, eq20 };

/// How many pairs of point and panel each equation turned down; a pair is counted at the first one that does.
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
    look_at_every_point(points, found_, [&](std::size_t i, Found& found) { look_at(i, points.position_t0(i), points.position_t1(i), motion, found); });
    gather(out);
  }

  /// As Swept answers it; looks at every point again.
  template <Points P>
  void redetect(const P& points, const Motion& motion, double surface_travel, double, std::vector<Contact>& out) {
    detect(points, motion, surface_travel, out);
  }

  /// The same for chosen points, in rising order, that somebody else displaced after `detect` in this step.
  template <Points P>
  void detect_again(const P& points, const Motion& motion, double, std::span<const std::size_t> which, std::vector<Contact>& out) {
    look_at_points(which, found_, [&](std::size_t i, Found& found) { look_at(i, points.position_t0(i), points.position_t1(i), motion, found); });
    gather(out);
  }

  /// As Swept answers it, for points without extent.
  template <Points P>
  std::vector<std::size_t> still_inside(const P& points, const Motion& motion, std::span<const std::size_t> which) const {
    return fccda::still_inside(*sides_, points, motion.t1, which, [](std::size_t) { return false; });
  }

  void moved(std::size_t) {}  ///< nothing is remembered
  void forget() {}

  /// As Swept answers it, for points without extent.
  template <Points P>
  std::vector<std::size_t> initial_overlap(const P& points, const Pose& pose) const {
    return fccda::initial_overlap(*sides_, points, pose);
  }

  /// As Swept answers it, for points without extent.
  std::vector<std::optional<Vec3d>> nearest_outside(std::span<const Vec3d> points, const Pose& pose) const {
    return fccda::nearest_outside(*sides_, points, pose);
  }

  const Effort& effort() const { return effort_; }
  const Rejections& rejections() const { return rejections_; }  ///< of all detections so far

  /// Why the step from x_t0 to x_t1 [m] was or was not taken for contact with a panel of the surface, numbered as in the file: for the
  /// panel that was truly crossed, the reason of a miss.
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
  void look_at(std::size_t point, const Vec3d& x_t0, const Vec3d& x_t1, const Motion& motion, Found& found) const;
  Verdict judge(const Planes& panel, const Vec3d& x_t0, const Vec3d& x_t1, const Motion& motion) const {
    return variant_ == Variant::literal ? judge_literal(panel, x_t0, x_t1, motion) : judge_corrected(panel, x_t0, x_t1);
  }
  static Verdict judge_literal(const Planes& panel, const Vec3d& x_t0, const Vec3d& x_t1, const Motion& motion);
  static Verdict judge_corrected(const Planes& panel, const Vec3d& x_t0, const Vec3d& x_t1);
  Vec3d relocated(const Plane& plane, const Vec3d& x_t1) const;

  std::shared_ptr<const Surface> surface_;
  ContactBounds region_;
  Variant variant_;
  std::vector<int> sign_;             // of each panel's normal as wound: -1 where the surface was turned outward, 0 where it was dropped
  std::vector<Plane> at_t0_, at_t1_;  // of this step
  Effort effort_;
  Rejections rejections_;
  std::vector<Found> found_;               // of each block
  std::shared_ptr<const PathTest> sides_;  // who is inside
};

}  // namespace fccda
