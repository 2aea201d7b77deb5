/// What a boundary condition gave its body, kept from step to step: its columns of history.csv, and its share of the energy balance.
///
/// Between two instants at which forces are known the work is F̄·Δū, with F̄ the mean of the two forces and ū the displacement that the
/// force does work on. Summed over steps this is what the kick and drift of symplectic Euler make of the force: they pair the force at
/// t_n with half the ways before and after it. For a linear body it is exact from one state of equilibrium to the next, too.
#pragma once

#include <array>
#include <span>
#include <string>

#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

class ReactionLedger {
 public:
  /// The forces at an instant: their sum [N], and the displacement [m] of the particles, weighted as the force is shared among them. Before the first instant
  /// both were 0.
  void record_force(const Vec3d& force, const Vec3d& displacement) {
    work_ += dot(0.5 * (force_ + force), displacement - displacement_);
    force_ = force, displacement_ = displacement;
  }

  /// The force acts for dt [s].
  void accumulate_impulse(double dt) { impulse_ += dt * force_; }
  /// Beside that force: an impulse [N s] and its work [J].
  void add(const Vec3d& impulse, double work) { impulse_ += impulse, work_ += work; }

  const Vec3d& force() const { return force_; }      ///< [N] on the body, at the latest positions
  double work() const { return work_; }              ///< [J] done on the body so far
  const Vec3d& impulse() const { return impulse_; }  ///< [N s] on the body so far

  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    std::array<double, 10> all{force_.x, force_.y, force_.z, displacement_.x, displacement_.y, displacement_.z, impulse_.x, impulse_.y, impulse_.z, work_};
    visit(name + ".account", std::span<double>(all));
    force_ = {all[0], all[1], all[2]}, displacement_ = {all[3], all[4], all[5]}, impulse_ = {all[6], all[7], all[8]}, work_ = all[9];
  }

 private:
  Vec3d force_{};         // [N]
  Vec3d displacement_{};  // [m]
  Vec3d impulse_{};       // [N s] so far
  double work_ = 0;       // [J]
};

}  // namespace perimpact
