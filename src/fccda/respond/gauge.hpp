/// Load gauges of a rigid body, the counterpart of load cells. A gauge sums the contact impulses on given parts of the surface:
///
///   Σ J,    Σ (x̄ - p) × J,    Σ a·((x̄ - p) × J)                [N s], [N m s], [N m s]
///
/// with J the impulse of a contact on the body and x̄ the relocated point, as in respond.hpp. The reference point p and the axis a
/// move with the body; each contact uses their position at the end of its step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/state.hpp"
#include "fccda/detect/contact.hpp"
#include "fccda/rigid_body/pose.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// One load gauge.
class Gauge {
 public:
  struct Mounting {
    std::vector<std::string> parts;  ///< of the surface; empty: all contacts, also of surfaces without panels
    Vec3d point{};                   ///< [m] reference point of the moments, in the body frame
    std::optional<Vec3d> axis;       ///< unit, through the point, in the body frame
  };

  /// Accumulated impulses, in world axes.
  struct Reading {
    Vec3d impulse{};          ///< [N s]
    Vec3d angular_impulse{};  ///< [N m s] about the point
    double about_axis = 0;    ///< [N m s] 0 without an axis
  };

  /// Throws InputError if the surface has no part of a given name.
  Gauge(const Mounting& mounting, const Surface& surface);

  /// Adds one contact; to be called from the `report` of respond(). `position`: of the point after contact; `motion`: of the body in the step.
  void add(const Contact& contact, const Vec3d& position, const Vec3d& impulse, const Motion& motion);

  const Reading& reading() const { return reading_; }
  bool has_axis() const { return axis_.has_value(); }
  void reset() { reading_ = {}; }

  /// State for checkpoints (base/state.hpp).
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
