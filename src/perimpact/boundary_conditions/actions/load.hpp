/// Dead load distributed over particles: the boundary conditions `body_force` and `pressure`.
///
///   F_i(t) = q f(t) w_i        [N]
///
///   body_force   q = force density [N/m³]                  w_i = volume [m³]
///   pressure     q = -p n, n the face's normal [Pa]        w_i = area of the face [m²]
///
/// Direction and areas of the load do not follow the deformation.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fccda/rigid_body/piecewise_linear.hpp"
#include "fccda/rigid_body/step.hpp"
#include "perimpact/boundary_conditions/actions/action_kernels.hpp"
#include "perimpact/boundary_conditions/actions/force_sum.hpp"
#include "perimpact/boundary_conditions/actions/reaction_ledger.hpp"
#include "perimpact/particles/particles.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

class Load {
 public:
  /// `weights`: w_i of each slot; `factor`: f [-].
  Load(std::vector<std::uint32_t> slots, std::vector<double> weights, const Particles& particles, const Vec3d& intensity, fccda::PiecewiseLinear factor);

  std::span<const std::uint32_t> slots() const { return slots_; }
  std::span<const double> weights() const { return weights_; }
  Vec3d force(double time) const { return total_weight_ * factor_.at(time) * intensity_; }  ///< [N] the sum over the particles

  /// Adds the load at that time to the force densities.
  ForceSum static_load(Particles& particles, double time) const;
  void apply_load(Particles& particles, const fccda::Step& next) {
    static_load(particles, next.t0);
    record(next.t0, weighted_displacement(particles));
  }
  Vec3d intensity(double time) const { return factor_.at(time) * intensity_; }  ///< q f(t)
  /// Records the load at that time; `weighted_displacement`: Σ w u.
  void record(double time, const Vec3d& weighted_displacement) { account.record_force(total_weight_ * intensity(time), weighted_displacement / total_weight_); }

  /// [J] kinetic energy from the load alone in the half step before `time`, for which no work has been recorded yet: Σ m (a dt/2)²/2.
  double half_kick(double time, double dt) const;

  /// [m] Σ w u/Σ w
  Vec3d displacement(const Particles& particles) const { return weighted_displacement(particles) / total_weight_; }
  Vec3d conjugate_displacement(const Particles& particles, double) const { return displacement(particles); }

  template <class Setup>
  static Traffic collectives_in_step(const Setup&) {
    return reduction_of_sums<Vec3d>();  // displacement()
  }

  ReactionLedger account;

  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    account.visit_record(name, visit);
  }

 private:
  Vec3d weighted_displacement(const Particles& particles) const;

  std::vector<std::uint32_t> slots_;
  std::vector<double> weights_;
  double total_weight_, squared_weights_, weights_by_mass_;  // Σ w, Σ w², Σ w²/m
  Vec3d intensity_;
  fccda::PiecewiseLinear factor_;
};

}  // namespace perimpact
