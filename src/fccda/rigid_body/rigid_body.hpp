/// A rigid body with six degrees of freedom, each free or constrained to a constant or prescribed velocity.
///
/// Free components follow
///   (m + a) dv = J,    I_ff dω_f = (angular impulse)_f,    I = R I_body Rᵀ about the centre of mass,
/// where a is the added mass of each axis and f denotes the free world axes; constrained components keep their velocity under any impulse.
/// Between impulses the angular momentum along the free axes is constant: this is the gyroscopic term of Euler's equations in conserved form.
/// The attitude is integrated by the midpoint rule on rotations, three of them composed to fourth order
/// (docs/theory/contact_response.md).
///
/// The reaction of a constraint takes the impulse that would change the component. Its work, v·(change of momentum - external impulse) and
/// the same for rotations, closes the energy balance.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "base/state.hpp"
#include "fccda/rigid_body/pose.hpp"

namespace fccda {

/// Mass properties of a rigid body.
struct RigidBodyProperties {
  double mass = 0;         ///< [kg]
  Vec3d centre_of_mass{};  ///< [m] in the body frame
  Mat3 inertia{};          ///< [kg m²] about the centre of mass, along the axes of the body frame
  Vec3d added_mass{};      ///< [kg] added mass of translation along the world axes, such as entrained water
};

/// ∫yz dm, ∫zx dm, ∫xy dm about the centre of mass [kg m²].
inline Vec3d products_of_inertia(const RigidBodyProperties& properties) {
  return -Vec3d{properties.inertia.row[1].z, properties.inertia.row[2].x, properties.inertia.row[0].y};
}

/// The degrees of freedom that impulses may change: translation along, then rotation about, the world's x, y and z.
struct FreeDegrees {
  std::array<bool, 6> free{};  ///< translations x, y, z, then rotations about x, y, z; all constrained by default

  bool translation(std::size_t axis) const { return free[axis]; }      ///< free along this axis
  bool rotation(std::size_t axis) const { return free[3 + axis]; }     ///< free about this axis
  bool any_rotation() const { return free[3] || free[4] || free[5]; }  ///< free about any axis
};

/// Linear and angular velocity.
struct Twist {
  Vec3d velocity{};  ///< [m/s] of the centre of mass
  Vec3d spin{};      ///< [rad/s] about world axes
};

/// A rigid body with its pose and velocities.
class RigidBody {
 public:
  /// `velocity` [m/s] is that of the centre of mass, `angular_velocity` [rad/s] has world axes. Throws InputError if a number is not finite,
  /// the mass is not positive, the attitude is not of unit length, or a rotation is free and the inertia is not positive definite.
  RigidBody(const RigidBodyProperties& properties, const Pose& pose, const Vec3d& velocity, const Vec3d& angular_velocity, const FreeDegrees& degrees);

  /// Moves the body for dt [s] without external impulses: the centre of mass straight, the attitude under constant angular momentum along the
  /// free axes. Throws InputError if dt is negative or not finite, or the body would rotate by more than π.
  Motion advance(double dt);

  /// The change of the free velocities by an impulse; `angular` is about the centre of mass [N s], [N m s].
  Twist velocity_change(const Vec3d& linear, const Vec3d& angular) const;

  /// Applies an impulse to the free velocities; `angular` is about the centre of mass [N s], [N m s]. Throws InputError if it is not finite.
  void add_impulse(const Vec3d& linear, const Vec3d& angular);

  /// Prescribes the velocity of a constrained degree of freedom (numbered as in FreeDegrees) [m/s], [rad/s]. The free ones keep their momentum.
  /// Throws InputError if the degree is free or the velocity is not finite.
  void drive(std::size_t degree, double velocity);

  const Pose& pose() const { return pose_; }                             ///< of the body frame
  const Vec3d& position_of_com() const { return com_; }                  ///< [m]
  const Vec3d& velocity() const { return velocity_; }                    ///< [m/s] of the centre of mass
  const Vec3d& angular_velocity() const { return spin_; }                ///< [rad/s] about world axes
  const RigidBodyProperties& properties() const { return properties_; }  ///< as given
  const FreeDegrees& degrees() const { return degrees_; }                ///< as given
  double mass() const { return properties_.mass; }                       ///< [kg] without added mass
  Mat3 inertia() const;                                                  ///< [kg m²] about the centre of mass, along world axes
  double kinetic_energy() const;                                         ///< [J]
  double constraint_work() const { return constraint_work_; }            ///< [J] so far, of the reactions of constrained and prescribed degrees
  Vec3d momentum() const;                                                ///< [kg m/s] including the added mass, as for energy and angular momentum
  Vec3d angular_momentum(const Vec3d& point) const;                      ///< [kg m²/s] about a point in the world frame

  /// `travel_bound` of pose.hpp for the points within `radius` [m] of the centre of mass.
  double travel_bound(const Motion& motion, double radius) const { return fccda::travel_bound(motion, properties_.centre_of_mass, radius); }

  /// See base/state.hpp.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit_vector(visit, "centre_of_mass", com_);
    visit_vector(visit, "velocity", velocity_);
    visit_vector(visit, "angular_velocity", spin_);
    const Quaternion& attitude = pose_.attitude();
    std::array<double, 4> parts{attitude.w, attitude.x, attitude.y, attitude.z};
    visit(std::string_view("attitude"), std::span<double>(parts));
    place({parts[0], parts[1], parts[2], parts[3]});
    visit(std::string_view("constraint_work"), std::span<double>(&constraint_work_, 1));
  }

 private:
  void place(const Quaternion& attitude);
  /// The angular velocity whose free components give `angular` along the free axes, with the constrained ones equal to those of `prescribed`.
  Vec3d spin_of(const Mat3& inertia, const Vec3d& angular, const Vec3d& prescribed) const;
  Vec3d spin_of(const Vec3d& angular) const { return spin_of(inertia(), angular, spin_); }
  /// The attitude after a rotation of dt [s] at the angular velocity that `angular` gives at midstep: symmetric, second order.
  Quaternion turned(const Quaternion& attitude, const Vec3d& angular, double dt) const;
  /// Adds the work of the reactions on rotations. They changed the angular momentum from `before` to its current value, less the external
  /// `angular`.
  void count_work_on_rotations(const Vec3d& before, const Vec3d& angular);

  RigidBodyProperties properties_;
  FreeDegrees degrees_;
  Vec3d com_;  // the state is this, the attitude and the velocities; the pose's position is derived
  Vec3d velocity_;
  Vec3d spin_;
  Pose pose_;
  double constraint_work_ = 0;
};

}  // namespace fccda
