/// Gauges: what load cells in a rigid body would read. A gauge sums what contact does to some parts of the surface:
///
///   Σ J,    Σ (x̄ - p) × J,    Σ a·((x̄ - p) × J)                [N s], [N m s], [N m s]
///
/// with J the impulse of a contact on the body and x̄ the place of the struck point, as in respond.hpp. The point p and the axis a
/// are fixed to the body and move with it; each contact counts with where they are at the end of its step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/state.hpp"
#include "fccda/detect/contact.hpp"
#include "fccda/rigid_body/pose.hpp"
#include "mesh/surface.hpp"

namespace fccda {

class Gauge {
 public:
  struct Mounting {
    std::vector<std::string> parts;  ///< of the surface; none: all contacts, those of surfaces without panels too
    Vec3d point{};                   ///< [m] about which moments are taken, in the body frame
    std::optional<Vec3d> axis;       ///< unit, through the point, in the body frame
  };

  /// What was summed, along the axes of the world.
  struct Reading {
    Vec3d impulse{};          ///< [N s]
    Vec3d angular_impulse{};  ///< [N m s] about the point
    double about_axis = 0;    ///< [N m s] 0 without an axis
  };

  /// Throws InputError where a part is unknown to the surface.
  Gauge(const Mounting& mounting, const Surface& surface);

  /// Call for each contact (from the `report` of respond()). `position`: of the struck point after contact; `motion`: of the body in the
  /// step.
  void add(const Contact& contact, const Vec3d& position, const Vec3d& impulse, const Motion& motion);

  const Reading& reading() const { return reading_; }
  bool has_axis() const { return axis_.has_value(); }
  void reset() { reading_ = {}; }

  /// As base/state.hpp says.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit_vector(visit, "impulse", reading_.impulse);
    visit_vector(visit, "angular_impulse", reading_.angular_impulse);
    visit("about_axis", reading_.about_axis);
  }

 private:
  bool feels(int panel) const { return feels_panel_.empty() || (panel >= 0 && feels_panel_[static_cast<std::size_t>(panel)]); }

  std::vector<bool> feels_panel_;  // empty: all
  Vec3d point_;
  std::optional<Vec3d> axis_;
  Reading reading_;
};

}  // namespace fccda
