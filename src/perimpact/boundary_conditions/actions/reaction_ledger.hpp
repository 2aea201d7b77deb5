/// Ledger of a boundary condition: force, impulse and work on its body, for history.csv and the energy balance.
///
/// Between two instants the work is F̄·Δū, with F̄ the mean of the two forces and ū the work-conjugate displacement (trapezoidal rule). Summed
/// over steps this is the work in symplectic Euler, which pairs the force at t_n with half the displacements before and after it. For a linear
/// body it is also exact between equilibrium states.
#pragma once

#include <array>
#include <span>
#include <string>

#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

class ReactionLedger {
 public:
  /// Records the resultant force [N] at an instant, and the displacement [m] of the particles weighted by their share of the force. Both are
  /// initially 0.
  void record_force(const Vec3d& force, const Vec3d& displacement) {
    work_ += dot(0.5 * (force_ + force), displacement - displacement_);
    force_ = force, displacement_ = displacement;
  }

  /// Adds the impulse of the force over dt [s].
  void accumulate_impulse(double dt) { impulse_ += dt * force_; }
  /// Adds a further impulse [N s] and its work [J].
  void add(const Vec3d& impulse, double work) { impulse_ += impulse, work_ += work; }

  const Vec3d& force() const { return force_; }      ///< [N] on the body, at the latest positions
  double work() const { return work_; }              ///< [J] cumulative, done on the body
  const Vec3d& impulse() const { return impulse_; }  ///< [N s] cumulative, on the body

  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    std::array<double, 10> all{force_.x, force_.y, force_.z, displacement_.x, displacement_.y, displacement_.z, impulse_.x, impulse_.y, impulse_.z, work_};
    visit(name + ".account", std::span<double>(all));
    force_ = {all[0], all[1], all[2]}, displacement_ = {all[3], all[4], all[5]}, impulse_ = {all[6], all[7], all[8]}, work_ = all[9];
  }

 private:
  Vec3d force_{};         // [N]
  Vec3d displacement_{};  // [m]
  Vec3d impulse_{};       // [N s] cumulative
  double work_ = 0;       // [J]
};

}  // namespace perimpact
