/// The impulse of contact on a body within a step, found together with the motion that it changes.
///
/// A step moves the body from t0 to t1 with the velocity that it has after the impulse J of the step, and J is what takes the points to where
/// the surface then is. With q(J) the motion under an assumed impulse and J(q) what respond() finds for a motion, J = J(q(J)) is wanted.
/// J(q) is piecewise smooth: each point in contact answers a change δv of the surface's velocity with
///
///   δJ = -B δv,    B = m n nᵀ, m 1 where friction holds the point, m (Δv/Δv·n) nᵀ where it slides or is pushed along the normal of t0
///
/// so that Newton's method ends after as many passes as it takes for the set of contacts to be found, and one more:
///
///   (1 + K A) δJ = J(q) - J,    K = Σ Gᵀ B G,  G = (1, -r×),    A: RigidBody::velocity_change
///
/// Each pass is a whole detection and response with the motion of the pass, from points as they were before the first. So no point is left
/// inside where the body ends, and momentum is kept to rounding, converged or not.
///
///   Coupling coupling(body);                       // at t0, with the loads and driven velocities of the step
///   Motion motion = coupling.advance(body, dt);
///   for (;;) {
///     ...                                          // detect and respond; add(…) for each contact
///     if (coupling.agrees(radius)) break;
///     ...                                          // points back to where they were
///     motion = coupling.correct(body, radius);
///   }
///   coupling.finish(body);
#pragma once

#include <array>

#include "fccda/detect/contact.hpp"
#include "fccda/rigid_body/rigid_body.hpp"

namespace fccda {

/// Of a body: [N s], and [N m s] about its centre of mass.
struct Impulse {
  Vec3d linear{}, angular{};
};

class Coupling {
 public:
  static constexpr int max_passes = 12;

  explicit Coupling(const RigidBody& at_t0) : at_t0_(at_t0) {}

  /// The first motion: that of no contact. Leaves the body at t1.
  Motion advance(RigidBody& body, double dt);

  /// What one contact of this pass gave the body [N s]; `place`: where it acts (place_of_push).
  void add(const Contact& contact, double mass, const Vec3d& place, const Vec3d& impulse, double friction);

  /// Whether the motion is that of the impulse found, to `share` of what the impulse changes. `radius` [m] of the surface about the centre of mass.
  bool agrees(double radius, double share = 1e-6) const;

  /// Begins the next pass. Returns its motion, and leaves the body at t1 of it.
  Motion correct(RigidBody& body, double radius);

  /// The same where the passes lead nowhere, as when several bodies squeeze the same points: back to the motion of no contact.
  Motion retreat(RigidBody& body, double radius);

  /// [m] no place of the surface is further from where it was at t1 of the pass before.
  double correction() const { return correction_; }

  /// Gives the body the impulse that was found. Returns the work of contact on it [J].
  double finish(RigidBody& body) const;

  const Impulse& found() const { return found_; }

 private:
  using Matrix6 = std::array<std::array<double, 6>, 6>;

  Motion move(RigidBody& body, double radius);

  RigidBody at_t0_;
  Motion motion_;
  Vec3d centre_of_mass_{};  // [m] at t1 of it
  Impulse assumed_, found_;
  Matrix6 stiffness_{};  // K [kg], [kg m], [kg m²]
  double correction_ = 0;
};

/// Adds the impulse; returns its work [J], exact for the velocities before and after.
double push(RigidBody& body, const Impulse& impulse);

}  // namespace fccda
