/// The path of a point in one step relative to a rotating body.
///
/// In the world frame the point and the body's centre of rotation both move straight; so in the body frame the path of the point is
///   p(s) = Q(s)ᵀ y(s) + centre,   y(s) = y_t0 + s (y_t1 - y_t0),   |p''| <= θ² ρ + 2 θ w,   0 <= s <= 1
/// where Q rotates by θ in the step, y leads from the centre to the point, ρ = max(|y_t0|, |y_t1|) and w = |y_t1 - y_t0|. A curve deviates
/// from its chord by at most an eighth of its second derivative. So the chord deviates from the arc by at most (θ² ρ + 2 θ w)/8, and a
/// polyline of n equal parts of the step by 1/n² of that.
///
/// The path is regarded as straight if its deviation (bulge) is below 1e-6 of the surface's size. Surfaces are no more accurate: STL files in
/// single precision round to 1e-7, and panels deviate more from the shape that they approximate. Only grazing contact can be missed. The
/// ends of the path are exact, so that no point gets inside undetected, and consecutive paths join.
#pragma once

#include <algorithm>
#include <cmath>

#include "fccda/contact_bounds/path.hpp"
#include "fccda/rigid_body/pose.hpp"

namespace fccda {

class CurvedPath;

/// The motion of a body over one step, prepared for the paths of many points. The motion must outlive the object.
class BodyView {
 public:
  static constexpr double straight_enough = 1e-6;  ///< of the surface's size

  /// A rotation by half a revolution takes 1100 parts for points at the farthest radius of a rotating surface. No more than this are made: a
  /// point that arrives within a step from many sizes away is followed more coarsely.
  static constexpr int max_parts = 1200;

  BodyView() = default;
  /// `size` [m] of the surface.
  BodyView(const Motion& motion, double size)
      : motion_(&motion),
        centre_t0_(motion.t0.to_world(motion.centre)),
        centre_t1_(motion.t1.to_world(motion.centre)),
        angle_(rotation_angle(motion)),
        tolerance_(straight_enough * size) {}

  const Motion& motion() const { return *motion_; }  ///< of the body
  /// The path of a point between its positions in the world frame [m] at both ends of the step.
  inline CurvedPath path(const Vec3d& position_t0, const Vec3d& position_t1) const;

 private:
  const Motion* motion_ = nullptr;
  Vec3d centre_t0_, centre_t1_;
  double angle_ = 0, tolerance_ = 0;
};

/// The path of one point in the body frame: a polyline of equal parts of the step.
class CurvedPath {
 public:
  const Path& chord() const { return chord_; }           ///< straight from the begin to the end [m]
  int parts() const { return parts_; }                   ///< 1: straight
  double bulge() const { return bulge_; }                ///< [m] bound of the deviation from the chord; 0 if regarded as straight
  double longest_part() const { return way_ / parts_; }  ///< [m]

  /// The begin of part k and the end of part k - 1.
  Vec3d place(int k) const {
    if (k == 0) return chord_.start;
    if (k == parts_) return chord_.end;
    const double fraction = static_cast<double>(k) / parts_;
    return pose_at(*motion_, fraction).to_body(x_t0_ + fraction * (x_t1_ - x_t0_));
  }

 private:
  friend class BodyView;
  const Motion* motion_ = nullptr;
  Vec3d x_t0_, x_t1_;  // world
  Path chord_;
  int parts_ = 1;
  double bulge_ = 0, way_ = 0;
};

inline CurvedPath BodyView::path(const Vec3d& position_t0, const Vec3d& position_t1) const {
  CurvedPath path;
  path.motion_ = motion_;
  path.x_t0_ = position_t0, path.x_t1_ = position_t1;
  path.chord_ = {motion_->t0.to_body(position_t0), motion_->t1.to_body(position_t1)};
  path.way_ = path.chord_.length();
  if (angle_ == 0) return path;
  const Vec3d y_t0 = position_t0 - centre_t0_, y_t1 = position_t1 - centre_t1_;
  const double rho = std::sqrt(std::max(squared_norm(y_t0), squared_norm(y_t1))), way = norm(y_t1 - y_t0);
  const double bulge = angle_ * (angle_ * rho + 2 * way) / 8;
  if (!(bulge > tolerance_) || !std::isfinite(bulge)) return path;
  path.bulge_ = bulge;
  path.way_ = angle_ * rho + way;
  path.parts_ = static_cast<int>(std::min(std::ceil(std::sqrt(bulge / tolerance_)), static_cast<double>(max_parts)));
  return path;
}

}  // namespace fccda
