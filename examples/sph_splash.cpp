// A block of water falls on a hull and splashes:  sph_splash [spacing of the particles in metres] [frames]
//
// The water is in sph.hpp. The hull acts through fccda only: there are no wall particles.
// Frames for ParaView: splash_000.vtk and so on, and splash_hull.vtk.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fccda/fccda.hpp>
#include <vector>

#include "sph.hpp"
#include "vtk.hpp"

using namespace fccda;
using sph::Water;

namespace {

constexpr double fall_speed = 3;                      // [m/s] initially
constexpr double end_time = 0.25;                     // [s]
constexpr double half_length = 0.6, parallel = 0.25;  // [m] half-lengths of the hull and of its parallel middle body
constexpr double half_beam = 0.25, depth = 0.25;      // [m]

/// Keel up (0 0 depth), deck down at z = 0, pointed at both ends.
Panels hull_panels() {
  Panels hull;
  hull.vertices = {{-half_length, 0, 0},      {-parallel, half_beam, 0},  {parallel, half_beam, 0}, {half_length, 0, 0},
                   {parallel, -half_beam, 0}, {-parallel, -half_beam, 0}, {-parallel, 0, depth},    {parallel, 0, depth}};
  hull.add_quad(1, 2, 7, 6), hull.add_quad(4, 5, 6, 7);                                                            // sides
  hull.add_triangle(0, 1, 6), hull.add_triangle(0, 6, 5), hull.add_triangle(3, 7, 2), hull.add_triangle(3, 4, 7);  // ends
  hull.add_quad(1, 5, 4, 2), hull.add_triangle(0, 5, 1), hull.add_triangle(3, 2, 4);                               // deck
  return hull;
}

/// Inside test by the face planes of the convex hull, independent of fccda.
bool is_in_hull(const Vec3d& x) {
  const double side = std::fabs(x.y) / half_beam + x.z / depth;
  return x.z > 0 && side < 1 && std::fabs(x.x) / half_length + (1 - parallel / half_length) * side < 1;
}

void write_frame(const Water& water, int frame) {
  std::vector<double> speed;
  for (const Vec3d& each : water.v) speed.push_back(norm(each));
  char path[32];
  std::snprintf(path, sizeof path, "splash_%03d.vtk", frame);
  write_vtk(path, water.x, {{"speed", speed}, {"pressure", water.pressure}});
}

}  // namespace

int main(int argc, char** argv) try {
  const double spacing = argc > 1 ? std::atof(argv[1]) : 0.025;
  const int frames = argc > 2 ? std::atoi(argv[2]) : 10;
  if (!(spacing >= 0.005 && spacing <= 0.1) || frames < 1) throw InputError("sph_splash: give a spacing between 0.005 and 0.1 m, then a number of frames.");

  Water water(spacing, {0.6, 0.4, 0.3}, depth, fall_speed);
  ContactDetector detector{Surface(hull_panels()), {.radius = spacing / 2}};
  RigidBody hull({.mass = 1}, Pose(), {}, {}, {});  // fixed
  write_vtk("splash_hull.vtk", hull_panels());

  const int per_frame = static_cast<int>(std::ceil(end_time / water.stable_step() / frames));
  const int steps = frames * per_frame;
  const double dt = end_time / steps;
  const double momentum_before = water.momentum_z(), weight = sph::gravity * water.mass * double(water.x.size());
  double impulse = 0, largest_force = 0, largest_error = 0;
  std::size_t contacts_found = 0, ever_inside = 0;
  for (int step = 0; step < steps; ++step) {
    if (step % per_frame == 0) write_frame(water, step / per_frame);
    const std::vector<Vec3d> before = water.advance(dt);
    const Motion motion = hull.advance(dt);
    const std::vector<Contact> contacts = detector.detect(motion, before, water.x);
    const ContactSum sum = respond(contacts, motion, hull, {.x_t0 = before, .x_t1 = water.x, .velocity = water.v, .mass = water.mass});

    contacts_found += contacts.size();
    impulse += sum.impulse.z;
    largest_force = std::max(largest_force, -sum.impulse.z / dt);
    largest_error = std::max(largest_error, std::fabs(water.momentum_z() + impulse - momentum_before + weight * dt * (step + 1)));
    ever_inside += static_cast<std::size_t>(std::ranges::count_if(water.x, is_in_hull));
  }
  write_frame(water, frames);

  std::printf("%zu particles, %d steps, %zu contacts; queries of the hull: %.1f particles per step\n", water.x.size(), steps, contacts_found,
              double(detector.swept().effort().points_tested) / steps);
  std::printf("particles ever inside the hull: %zu\n", ever_inside);
  std::printf("vertical impulse on the hull: %.4f N s; largest force %.0f N, the water weighs %.0f N\n", impulse, largest_force, weight);
  std::printf("momentum of the water + impulse on the hull - impulse of gravity: %.1e of the momentum at most\n", largest_error / std::fabs(momentum_before));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
}
