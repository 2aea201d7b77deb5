// Points fall on a mesh, slide, stick, or fall past it:  falling_points [surface.stl | surface.obj]
// Writes the final positions to falling_points.csv. A minimal program.
#include <cstdio>
#include <exception>
#include <fccda/fccda.hpp>
#include <set>
#include <vector>

using namespace fccda;

int main(int argc, char** argv) try {
  const Surface surface(argc > 1 ? read_panels(argv[1]) : make_sphere({.diameter = 2, .edge_length = 0.1}));
  ContactDetector detector(surface, {.radius = 0.02});  // the points are balls [m]
  RigidBody body({.mass = 1}, Pose(), {}, {}, {});      // at rest, all degrees of freedom fixed

  // A sheet of 41 × 41 points above the mesh, a fifth wider than the mesh.
  const Vec3d centre = surface.report().bounds.centre(), size = surface.report().bounds.size();
  std::vector<Vec3d> x_t0, x_t1, velocity(41 * 41);
  for (int i = 0; i < 41 * 41; ++i) x_t1.push_back(centre + Vec3d{0.6 * size.x * (i % 41 - 20) / 20.0, 0.6 * size.y * (i / 41 - 20) / 20.0, size.z});

  const double dt = 0.01;  // [s] a point falls up to 0.2 m per step, ten radii
  std::set<std::size_t> landed;
  for (int step = 0; step < 200; ++step) {
    x_t0 = x_t1;
    for (std::size_t i = 0; i < x_t1.size(); ++i) {
      velocity[i].z -= 9.81 * dt;
      x_t1[i] += dt * velocity[i];
    }
    const Motion motion = body.advance(dt);
    const std::vector<Contact> contacts = detector.detect(motion, x_t0, x_t1);
    respond(contacts, motion, body, {.x_t0 = x_t0, .x_t1 = x_t1, .velocity = velocity, .mass = 1.0}, 0.5);  // Coulomb friction of 0.5
    for (const Contact& contact : contacts) landed.insert(contact.point);
  }

  std::printf("%zu of %zu points landed, %zu are inside\n", landed.size(), x_t1.size(), detector.points_inside(body.pose(), x_t1).size());
  if (std::FILE* file = std::fopen("falling_points.csv", "w")) {
    for (std::size_t i = 0; i < x_t1.size(); ++i) std::fprintf(file, "%.17g,%.17g,%.17g,%d\n", x_t1[i].x, x_t1[i].y, x_t1[i].z, int(landed.count(i)));
    std::fclose(file);
  }
  return 0;
} catch (const std::exception& error) {  // InputError describes a faulty mesh
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
}
