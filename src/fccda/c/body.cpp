#include <algorithm>
#include <span>
#include <string_view>

#include "base/finite.hpp"
#include "fccda/c/convert.hpp"
#include "fccda/c/guarded.hpp"
#include "fccda/c/handles.hpp"

using namespace fccda;
using namespace fccda::c_interface;

namespace {

RigidBody body_of(const fccda_body_properties& given) {
  const double(&inertia)[9] = given.inertia;
  const RigidBodyProperties properties{
      .mass = given.mass,
      .centre_of_mass = vector_of(given.centre_of_mass),
      .inertia = {{{inertia[0], inertia[1], inertia[2]}, {inertia[3], inertia[4], inertia[5]}, {inertia[6], inertia[7], inertia[8]}}},
      .added_mass = vector_of(given.added_mass)};
  FreeDegrees degrees;
  for (std::size_t k = 0; k < 6; ++k) degrees.free[k] = given.is_free[k] != 0;
  return RigidBody(properties, pose_of(given.pose), vector_of(given.velocity), vector_of(given.angular_velocity), degrees);
}

/// The numbers of a body's state by their names in RigidBody::visit_state.
template <class State>
auto numbers_named(State& state, std::string_view name) {
  if (name == "centre_of_mass") return std::span(state.centre_of_mass, 3);
  if (name == "velocity") return std::span(state.velocity, 3);
  if (name == "angular_velocity") return std::span(state.angular_velocity, 3);
  if (name == "attitude") return std::span(state.attitude, 4);
  return std::span(&state.constraint_work, 1);
}

void expect_usable(const fccda_body_state& state) {
  expect_finite(vector_of(state.centre_of_mass), "rigid body: the centre of mass of the state");
  expect_finite(vector_of(state.velocity), "rigid body: the velocity of the state");
  expect_finite(vector_of(state.angular_velocity), "rigid body: the angular velocity of the state");
  expect_finite(state.constraint_work, "rigid body: the constraint work of the state");
  fccda_pose pose{};
  std::ranges::copy(state.attitude, pose.attitude);
  expect_usable(pose_of(pose), "rigid body: in the state ");
}

}  // namespace

fccda_status fccda_body_create(const fccda_body_properties* properties, fccda_body** body) {
  return guarded([&] {
    fccda_body*& out = given(body, "body");
    out = nullptr;
    out = new fccda_body{body_of(given(properties, "properties"))};
  });
}

fccda_status fccda_body_advance(fccda_body* body, double dt, fccda_motion* motion) {
  return guarded([&] {
    fccda_motion& out = given(motion, "motion");
    out = as_c(given(body, "body").body.advance(dt));
  });
}

fccda_status fccda_body_add_impulse(fccda_body* body, const double impulse[3], const double angular_impulse[3]) {
  return guarded([&] {
    given(impulse, "impulse"), given(angular_impulse, "angular_impulse");
    given(body, "body").body.add_impulse({impulse[0], impulse[1], impulse[2]}, {angular_impulse[0], angular_impulse[1], angular_impulse[2]});
  });
}

fccda_status fccda_body_drive(fccda_body* body, int32_t degree, double velocity) {
  return guarded([&] {
    if (degree < 0 || degree > 5) throw InputError("rigid body: there is no degree of freedom " + std::to_string(degree) + "; they are numbered from 0 to 5.");
    given(body, "body").body.drive(static_cast<std::size_t>(degree), velocity);
  });
}

fccda_status fccda_body_pose(const fccda_body* body, fccda_pose* pose) {
  return guarded([&] { given(pose, "pose") = as_c(given(body, "body").body.pose()); });
}

fccda_status fccda_body_kinetic_energy(const fccda_body* body, double* energy) {
  return guarded([&] { given(energy, "energy") = given(body, "body").body.kinetic_energy(); });
}

fccda_status fccda_body_state_of(const fccda_body* body, fccda_body_state* state) {
  return guarded([&] {
    RigidBody read = given(body, "body").body;
    fccda_body_state& out = given(state, "state");
    read.visit_state([&](std::string_view name, std::span<double> numbers) { std::ranges::copy(numbers, numbers_named(out, name).begin()); });
  });
}

fccda_status fccda_body_resume(fccda_body* body, const fccda_body_state* state) {
  return guarded([&] {
    RigidBody& changed = given(body, "body").body;
    const fccda_body_state& from = given(state, "state");
    expect_usable(from);
    changed.visit_state([&](std::string_view name, std::span<double> numbers) { std::ranges::copy(numbers_named(from, name), numbers.begin()); });
  });
}

void fccda_body_destroy(fccda_body* body) { delete body; }
