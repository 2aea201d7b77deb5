// Two dimensions, discs of different radii, two bodies, and points distributed over processes: discs fall past a toothed wheel, which turns under
// them, onto a floor. One process, or several that emulate the ranks of an MPI program: each has a part of the points with separate detectors, the
// surfaces are shared, and the wheel receives the sum of all impulses. Compares the results of 1 and 4 processes.
#include <cmath>
#include <cstdio>
#include <fccda/fccda.hpp>
#include <numbers>
#include <random>
#include <vector>

using namespace fccda;

constexpr std::size_t count = 400;  // of discs

// Data of one process: a part of the points, and a detector for each body.
struct Rank {
  std::vector<Vec3d> x_t0, x_t1, velocity;
  std::vector<double> radius, mass;
  ContactDetector wheel, floor;
  ContactSum sum{};  // sum of this step, on the wheel
};

std::vector<Rank> shared_out(std::size_t ranks, const SharedSurface& wheel, const SharedSurface& floor) {
  std::vector<Rank> out;
  for (std::size_t r = 0; r < ranks; ++r) out.push_back({{}, {}, {}, {}, {}, ContactDetector(wheel), ContactDetector(floor)});
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> even(0, 1);
  for (std::size_t i = 0; i < count; ++i) {
    Rank& rank = out[i % ranks];
    const double size = 0.002 + 0.01 * even(random), x = 1.2 * even(random) - 0.2, y = 0.6 + 2 * even(random);
    rank.radius.push_back(size);
    rank.mass.push_back(1000 * std::numbers::pi * size * size);  // [kg] of a disc of unit thickness
    rank.x_t1.push_back({x, y, 0});                              // in the plane z = 0, where all motion remains
    rank.velocity.push_back({});
  }
  return out;
}

struct Outcome {
  std::vector<Vec3d> places;
  double angle = 0, off_plane = 0;
  std::size_t contacts = 0, inside = 0;
};

Outcome run(std::size_t ranks) {
  PrismShape teeth{.outline = {}, .height = 1};
  for (int k = 0; k < 48; ++k) {
    const double angle = k * std::numbers::pi / 24, r = k % 2 == 0 ? 0.5 : 0.4;
    teeth.outline.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  const SharedSurface wheel_surface = share(Surface(make_prism(teeth))), floor_surface = share(Surface(make_box({.size = {10, 1, 1}})));
  RigidBody wheel({.mass = 600, .inertia = Mat3::diagonal({100, 100, 70})}, Pose(), {}, {}, {{false, false, false, false, false, true}});
  RigidBody floor({.mass = 1}, Pose({0, -1.5, 0}), {}, {}, {});
  std::vector<Rank> parts = shared_out(ranks, wheel_surface, floor_surface);

  Outcome outcome;
  const double dt = 1e-3;
  for (int step = 0; step < 1000; ++step) {
    const Motion wheel_motion = wheel.advance(dt), floor_motion = floor.advance(dt);
    for (Rank& rank : parts) {  // each in a separate process
      rank.x_t0 = rank.x_t1;
      for (std::size_t i = 0; i < rank.x_t1.size(); ++i) {
        rank.velocity[i].y -= 9.81 * dt;
        rank.x_t1[i] += dt * rank.velocity[i];
      }
      const PointArrays points{.x_t0 = rank.x_t0, .x_t1 = rank.x_t1, .velocity = rank.velocity, .mass = rank.mass};
      const std::vector<Contact> on_wheel = rank.wheel.detect(wheel_motion, rank.x_t0, rank.x_t1, rank.radius);
      rank.sum = respond_without_body(on_wheel, wheel_motion, wheel, points, 0.3);
      const std::vector<Contact> on_floor = rank.floor.detect(floor_motion, rank.x_t0, rank.x_t1, rank.radius);
      respond(on_floor, floor_motion, floor, points, 0.3);
      for (const Contact& contact : on_wheel) rank.floor.moved(contact.point);  // report points displaced by one body to the detector of the other
      for (const Contact& contact : on_floor) rank.wheel.moved(contact.point);
    }
    ContactSum sum;  // MPI_Allreduce of seven numbers; the body then moves identically in all processes
    for (const Rank& rank : parts) sum += rank.sum;
    wheel.add_impulse(sum.impulse, sum.angular_impulse);
    outcome.angle += dt * wheel.angular_velocity().z;
    outcome.contacts += sum.contacts;
  }
  for (std::size_t i = 0; i < count; ++i) outcome.places.push_back(parts[i % ranks].x_t1[i / ranks]);
  for (const Vec3d& place : outcome.places) outcome.off_plane = std::fmax(outcome.off_plane, std::fabs(place.z));
  for (const Rank& rank : parts)
    outcome.inside +=
        rank.wheel.points_inside(wheel.pose(), rank.x_t1, rank.radius).size() + rank.floor.points_inside(floor.pose(), rank.x_t1, rank.radius).size();
  return outcome;
}

int main() {
  const Outcome one = run(1), four = run(4);
  double apart = 0;
  for (std::size_t i = 0; i < one.places.size(); ++i) apart = std::fmax(apart, norm(one.places[i] - four.places[i]));
  std::printf("%zu contacts with the wheel, which turned by %.4f rad; %zu of %zu discs inside, at most %g m off the plane\n", one.contacts, one.angle,
              one.inside, count, one.off_plane);
  std::printf("distributed over 4: turned by %.4f rad, discs at most %g m from those of one\n", four.angle, apart);
}
