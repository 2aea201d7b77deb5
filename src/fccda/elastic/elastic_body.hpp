/// An elastic body: rigid motion, and vibration modes superposed in the body frame.
///
///   x_v = x(t) + R(t) (X_v + Σ_k φ_kv q_k)
///
/// The modal coordinates are oscillators (modes.hpp), integrated exactly between impulses. Deflections are small: inertial forces between rigid
/// motion and modes are neglected, and moments act on the deformed shape. Modes of a body with free degrees are those of the free body, which have no
/// momentum: momentum is that of the rigid motion. Modes of a body whose motion is prescribed may be those of the clamped body; the support
/// takes their momentum.
///
/// Impulses act at t0 of a step, so that a constant force F deflects a mode by F/ω² (θ/2)/tan(θ/2) with θ = ω dt: by 2 % too little at θ = 0.5, and
/// by nothing at θ = π.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/state.hpp"
#include "fccda/elastic/modes.hpp"
#include "fccda/elastic/structure.hpp"
#include "fccda/rigid_body/rigid_body.hpp"

namespace fccda {

/// Rigid body with modes; the generalised coordinates are its 6 degrees of freedom about the centre of mass and the modes.
class ElasticBody final : public Structure {
 public:
  /// `body` must exist as long as this; `vertices` [m] in the body frame, undeformed. At rest in its modes. Throws InputError if a shape has another
  /// number of vertices, or a frequency or damping ratio is out of range.
  ElasticBody(RigidBody& body, Modes modes, std::span<const Vec3d> vertices);

  std::size_t size() const override { return 6 + modes_.size(); }
  std::size_t vertex_count() const override { return vertices_.size(); }
  void begin(const Step& step) override;
  void move(std::span<const double> impulse, std::span<Vec3d> vertices) override;
  std::vector<std::size_t> coordinates_of(std::span<const int> vertices) const override;
  void velocity_change(std::span<const std::size_t> coordinates, std::span<const double> impulse, std::span<double> velocity) const override;
  Vec3d vertex_velocity(std::size_t vertex, std::span<const double> velocity) const override;
  void add_vertex_impulse(std::size_t vertex, const Vec3d& impulse, std::span<double> generalised) const override;
  double finish(std::span<const double> assumed, std::span<const double> found) override;

  const Modes& modes() const { return modes_; }
  std::span<const double> amplitudes() const { return amplitude_; }     ///< [m √kg] q at the end of the last step
  std::vector<Vec3d> deformed() const;                                  ///< [m] vertices in the body frame at the end of the last step
  void place(std::span<Vec3d> vertices) const;                          ///< writes the current vertices in the world frame [m]
  Vec3d deflection(std::size_t vertex) const;                           ///< [m] in the body frame
  SymmetricTensor stress(std::size_t vertex) const;                     ///< [Pa] by modal superposition; 0 where modes have no stresses
  double kinetic_energy() const;                                        ///< [J] of the modes at the end of the last step, as Impactor::kinetic_energy
  double kinetic_energy_of_scheme() const;                              ///< [J] without half of the last impulse: changes by the work of contact exactly
  double elastic_energy() const;                                        ///< [J]
  double damping_dissipation() const { return dissipation_; }           ///< [J] cumulative
  static double largest_angle(std::span<const Mode> modes, double dt);  ///< [rad] θ of the highest mode

  /// See base/state.hpp. The rigid body visits its own.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit("modal_amplitudes", std::span<double>(amplitude_));
    visit("modal_velocities", std::span<double>(velocity_));
    visit("modal_impulses", std::span<double>(last_impulse_));
    visit("modal_damping_dissipation", dissipation_);
  }

 private:
  /// Exact solution of a damped oscillator over the step: (q, q̇) at t1 for those after the impulse at t0.
  struct Propagator {
    double qq, qv, vq, vv;
  };
  void prepare(double dt);

  RigidBody& body_;
  Modes modes_;
  std::vector<Vec3d> vertices_;
  std::vector<Vec3d> shapes_;                 // of each vertex, mode by mode
  std::vector<double> amplitude_, velocity_;  // q [m √kg], q̇ at t1, before the impulse of the coming step
  std::vector<double> last_impulse_;          // of the modes in the last step
  double dissipation_ = 0;
  RigidBody at_t0_;  // of the step in progress, as are these:
  std::vector<double> amplitude_t0_, velocity_t0_;
  std::vector<Propagator> propagators_;
  double dt_ = 0;
};

}  // namespace fccda
