// Arrays of a solver, accessed in place through the Points interface: no copies, and with the blocks and bounds of the solver.
// The solver is a set of grains without forces, with three arrays per vector, sorted into blocks of 100. The result is compared with
// that of the plain call.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fccda/fccda.hpp>
#include <memory>
#include <vector>

using namespace fccda;

/// Data of the solver.
struct Grains {
  using Array = std::vector<double>;
  std::array<Array, 3> x, v;    // [m], [m/s]
  Array mass;                   // [kg]
  std::vector<double> fastest;  // [m/s] largest speed per block, computed when the grains move
  static constexpr std::size_t block = 100;

  void add(const Vec3d& position, const Vec3d& velocity, double m) {
    for (std::size_t axis = 0; axis < 3; ++axis) x[axis].push_back(position[axis]), v[axis].push_back(velocity[axis]);
    mass.push_back(m);
  }

  void move(double dt) {
    fastest.assign((mass.size() + block - 1) / block, 0);
    for (std::size_t i = 0; i < mass.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) x[axis][i] += dt * v[axis][i];
      fastest[i / block] = std::max(fastest[i / block], std::hypot(v[0][i], v[1][i], v[2][i]));
    }
  }
};

/// Access for fccda: Points (detect/points.hpp) and PointsInContact (respond/respond.hpp).
struct GrainPoints {
  Grains& grains;
  double dt;

  std::size_t size() const { return grains.mass.size(); }
  bool occupied(std::size_t i) const { return grains.mass[i] > 0; }  // grains without mass have been removed
  Vec3d velocity(std::size_t i) const { return {grains.v[0][i], grains.v[1][i], grains.v[2][i]}; }
  Vec3d position_t1(std::size_t i) const { return {grains.x[0][i], grains.x[1][i], grains.x[2][i]}; }
  Vec3d position_t0(std::size_t i) const { return position_t1(i) - dt * velocity(i); }
  double mass(std::size_t i) const { return grains.mass[i]; }

  std::size_t block_count() const { return grains.fastest.size(); }
  std::size_t block_begin(std::size_t block) const { return block * Grains::block; }
  std::size_t block_end(std::size_t block) const { return std::min(size(), (block + 1) * Grains::block); }
  double block_travel(std::size_t block) const { return dt * grains.fastest[block]; }

  void set(std::size_t i, const Vec3d& position, const Vec3d& velocity) const {
    for (std::size_t axis = 0; axis < 3; ++axis) grains.x[axis][i] = position[axis], grains.v[axis][i] = velocity[axis];
  }
};

int main() try {
  Grains grains;
  for (int i = 0; i < 20'000; ++i) {  // on a spiral over a sphere, all moving inward
    const double z = 1 - (2 * i + 1) / 20'000.0, around = 2.399963 * i, r = std::sqrt(1 - z * z);
    const Vec3d out{r * std::cos(around), r * std::sin(around), z};
    grains.add((1 + 0.5 * (i % 7)) * out, -(1 + 0.1 * (i % 3)) * out, 1e-3);
  }

  // A rotating slab among them, free in all six degrees of freedom.
  const auto surface = std::make_shared<const Surface>(make_box({.size = {1.2, 0.8, 0.2}, .edge_length = 0.1}));
  const RigidBodyProperties properties{.mass = 5, .inertia = Mat3::diagonal({0.28, 0.62, 0.87})};
  RigidBody slab(properties, Pose(), {}, {0, 0, 0.3}, {{true, true, true, true, true, true}});
  const double reach = surface->radius_about(properties.centre_of_mass);

  Swept detector(surface, Unbounded(), 0.01);
  ContactDetector plain(*surface, {.radius = 0.01});

  const double dt = 0.01;  // [s]
  std::size_t found = 0, agreed = 0;
  Vec3d momentum_of_grains;
  double exchanged = 0;  // [N s]
  for (std::size_t i = 0; i < grains.mass.size(); ++i) momentum_of_grains += grains.mass[i] * GrainPoints{grains, dt}.velocity(i);
  for (int step = 0; step < 100; ++step) {
    grains.move(dt);
    const Motion motion = slab.advance(dt);
    GrainPoints points{grains, dt};

    std::vector<Contact> contacts;
    detector.detect(points, motion, slab.travel_bound(motion, reach), contacts);

    std::vector<Vec3d> x_t0;
    for (std::size_t i = 0; i < points.size(); ++i) x_t0.push_back(points.position_t0(i));
    const std::vector<Contact> same = plain.detect(motion, x_t0, {grains.x[0].data(), grains.x[1].data(), grains.x[2].data(), points.size()});
    found += contacts.size();
    agreed += std::equal(contacts.begin(), contacts.end(), same.begin(), same.end(),
                         [](const Contact& a, const Contact& b) { return a.point == b.point && a.relocation == b.relocation; });

    exchanged += norm(respond(points, contacts, motion, slab, 0.2).impulse);
  }
  for (std::size_t i = 0; i < grains.mass.size(); ++i) momentum_of_grains -= grains.mass[i] * GrainPoints{grains, dt}.velocity(i);

  std::printf("%zu contacts, the plain call found the same in %zu of 100 steps\n", found, agreed);
  std::printf("tested against the surface: %.1f of 20000 grains a step\n", double(detector.effort().points_tested) / 100);
  std::printf("momentum the grains lost less what the slab gained: %.1e of what was exchanged\n", norm(momentum_of_grains - slab.momentum()) / exchanged);
  return agreed == 100 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
}
