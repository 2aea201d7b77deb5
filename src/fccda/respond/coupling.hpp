/// Implicit coupling of a rigid body's motion and its contact impulse within a step, solved by Newton's method.
///
/// A step moves the body from t0 to t1 with the velocity after the impulse J of the step, and J depends on where that motion takes the surface.
/// With q(J) the motion under an assumed impulse and J(q) the impulse that respond() computes for a motion, the equation is J = J(q(J)).
/// J(q) is piecewise smooth: a change δv of the surface velocity changes the impulse of each point in contact by
///
///   δJ = -B δv,    B = m n nᵀ;  m 1 for a sticking point;  m (Δv/Δv·n) nᵀ where the point slides or the impulse acts along the normal of t0
///
/// Newton's method therefore converges one pass after the set of contacts is final:
///
///   (1 + K A) δJ = J(q) - J,    K = Σ Gᵀ B G,  G = (1, -r×),    A: RigidBody::velocity_change
///
/// Where contacts come and go from pass to pass, or points stick and slide by turns, it need not converge. After `undamped_passes` a pass that is
/// no improvement on the best one so far is therefore repeated with half of the change δJ that led to it. An impulse that is found, but was not
/// assumed, changes the velocity of the body and not its motion of the step: it may add energy, the more the lighter the body.
///
/// Each pass repeats detection and response with its own motion, from the positions before the first pass. No point therefore remains inside the
/// body at t1, and momentum is conserved to rounding, converged or not.
///
///   Coupling coupling(body);                       // at t0, with the loads and prescribed velocities of the step
///   Motion motion = coupling.advance(body, dt);
///   for (;;) {
///     ...                                          // detect and respond; add(…) for each contact
///     if (coupling.agrees(radius)) break;
///     ...                                          // restore the points
///     motion = coupling.correct(body, radius);
///   }
///   coupling.finish(body);
#pragma once

#include <array>
#include <limits>

#include "fccda/detect/contact.hpp"
#include "fccda/rigid_body/rigid_body.hpp"

namespace fccda {

/// Impulse on a body: linear [N s], and angular [N m s] about its centre of mass.
struct Impulse {
  Vec3d linear{}, angular{};
};

/// Newton iteration for the contact impulse of one step.
class Coupling {
 public:
  static constexpr int max_passes = 40, undamped_passes = 6;

  explicit Coupling(const RigidBody& at_t0) : at_t0_(at_t0) {}

  /// Starts with the contact-free motion. Leaves the body at t1.
  Motion advance(RigidBody& body, double dt);

  /// Adds the impulse [N s] of one contact of this pass; `place`: its point of application (point_of_application). `rigidity`: change of the normal impulse
  /// with the motion, over that of rigid contact (`Crushing::rigidity`).
  void add(const Contact& contact, double mass, const Vec3d& place, const Vec3d& impulse, double friction, double rigidity = 1);

  /// Returns whether the iteration has converged: assumed and computed impulse agree to the fraction `share` of the velocity change that the impulse
  /// causes. `radius` [m] of the surface about the centre of mass.
  bool agrees(double radius, double share = 1e-6) const;

  /// Begins the next pass with a Newton update, damped where that is needed. Returns its motion and leaves the body at its t1.
  Motion correct(RigidBody& body, double radius);

  /// Begins the next pass as the one in which assumed and computed impulse differed least. For iterations that do not converge.
  Motion retreat(RigidBody& body, double radius);

  /// [m] upper bound on the displacement of the surface at t1 between the last two passes.
  double correction() const { return correction_; }

  /// Applies the computed impulse to the body. Returns the work of contact on it [J].
  double finish(RigidBody& body) const;

  const Impulse& found() const { return found_; }

 private:
  using Matrix6 = std::array<std::array<double, 6>, 6>;

  struct Pass {
    Impulse assumed, change;                                 // Newton update that follows it
    double error = std::numeric_limits<double>::infinity();  // [m/s]
  };

  double error(double radius) const;
  Impulse newton_update(double radius) const;
  Motion move(RigidBody& body, double radius);

  RigidBody at_t0_;
  Motion motion_;
  Vec3d centre_of_mass_{};  // [m] at t1 of it
  Impulse assumed_, found_;
  Matrix6 stiffness_{};  // K [kg], [kg m], [kg m²]
  double correction_ = 0;
  Pass best_;           // in which assumed and computed impulse differed least
  double damping_ = 1;  // factor of its change in the last pass
  int passes_ = 0;      // completed
};

/// Adds the impulse; returns its work [J], exact for the velocities before and after.
double push(RigidBody& body, const Impulse& impulse);

}  // namespace fccda
