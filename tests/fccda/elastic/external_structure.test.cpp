#include "fccda/elastic/external_structure.hpp"

#include <doctest/doctest.h>

#include <random>

#include "fccda/elastic/impacts.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"

using namespace deforming;

namespace {

/// Vertices without forces among them.
struct Loose {
  std::vector<Vec3d> x, v;
  std::vector<double> m;
  double dt = 0;

  StructureSolver solver() {
    return {.advance =
                [this](const Step& step) {
                  dt = step.dt;
                  for (std::size_t i = 0; i < x.size(); ++i) x[i] += dt * v[i];
                  return x;
                },
            .apply =
                [this](std::span<const Vec3d> impulses) {
                  for (std::size_t i = 0; i < x.size(); ++i) v[i] += impulses[i] / m[i], x[i] += dt / m[i] * impulses[i];
                },
            .energy = {}};
  }
  Vec3d momentum() const {
    Vec3d sum{};
    for (std::size_t i = 0; i < x.size(); ++i) sum += m[i] * v[i];
    return sum;
  }
  double kinetic_energy() const {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += 0.5 * m[i] * squared_norm(v[i]);
    return sum;
  }
};

}  // namespace

TEST_CASE("external structure: heavy points that meet light vertices in one step leave with them, and neither momentum nor energy is added") {
  std::mt19937_64 random(43);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double friction : {0.0, 0.3})
    for (const double ratio : {0.1, 1.0, 30.0}) {  // mass of a point over that of a vertex; some 20 points meet the panels of each vertex
      const Panels panels = sheet(4);
      Loose loose{panels.vertices, std::vector<Vec3d>(panels.vertices.size(), Vec3d{0, 0, 0.5}), std::vector<double>(panels.vertices.size(), 0.2)};
      ExternalStructure structure(loose.solver(), loose.m, panels.vertices);
      Impacts impacts(structure, open_surface(panels), 0.001);
      impacts.friction = friction;
      for (int i = 0; i < 100; ++i) impacts.add({0.4 * unit(random), 0.4 * unit(random), 0.0011}, {0.2, 0, -2}, 0.2 * ratio);
      const Vec3d before = impacts.momentum() + loose.momentum();
      const double energy = impacts.kinetic_energy() + loose.kinetic_energy();
      impacts.step(1e-3);
      CHECK(impacts.most_passes < StructureCoupling::max_passes);
      CHECK(norm(impacts.momentum() + loose.momentum() - before) == fixtures::absolute(0, 1e-12 * norm(before), "N s"));
      const double after = impacts.kinetic_energy() + loose.kinetic_energy();
      CHECK(after < energy);
      CHECK(after > 0.5 * squared_norm(before) / (0.2 * (25 + 100 * ratio)));  // of all moving as one
      impacts.step(1e-3);
      CHECK(impacts.kinetic_energy() + loose.kinetic_energy() <= after * (1 + 1e-9));
    }
}

TEST_CASE("external structure: where passes do not converge, on light vertices of a bent sheet, momentum is conserved and no energy is added") {
  std::mt19937_64 random(44);
  std::uniform_real_distribution<double> unit(-1, 1);
  int most_passes = 0;
  for (const double friction : {0.0, 0.1, 0.5})
    for (const double ratio : {1.0, 10.0, 30.0}) {  // mass of a point over that of a vertex
      const Panels panels = sheet(4);
      Loose loose{panels.vertices, std::vector<Vec3d>(panels.vertices.size()), std::vector<double>(panels.vertices.size(), 0.2)};
      ExternalStructure structure(loose.solver(), loose.m, panels.vertices);
      Impacts impacts(structure, open_surface(panels), 0);
      impacts.friction = friction;
      for (int i = 0; i < 100; ++i)
        impacts.add({0.4 * unit(random), 0.4 * unit(random), 1e-3 + 1e-4 * unit(random)}, {3 + unit(random), unit(random), -2}, 0.2 * ratio);
      const Vec3d before = impacts.momentum() + loose.momentum();
      double energy = impacts.kinetic_energy() + loose.kinetic_energy();
      for (int step = 0; step < 3; ++step) {
        impacts.step(1e-3);
        CHECK(norm(impacts.momentum() + loose.momentum() - before) == fixtures::absolute(0, 1e-12 * norm(before), "N s"));
        const double after = impacts.kinetic_energy() + loose.kinetic_energy();
        CHECK(after <= energy * (1 + 1e-6));  // passes agree to 1e-6
        energy = after;
      }
      most_passes = fixtures::larger(most_passes, impacts.most_passes);
    }
  CHECK(most_passes == StructureCoupling::max_passes);
}

TEST_CASE("external structure: one point at a vertex and the vertex leave at the velocity of their common momentum") {
  const Panels panels = sheet(2);
  Loose loose{panels.vertices, std::vector<Vec3d>(9), std::vector<double>(9, 0.7)};
  ExternalStructure structure(loose.solver(), loose.m, panels.vertices);
  Impacts impacts(structure, open_surface(panels), 0);
  impacts.add({0, 0, 1e-9}, {0, 0, -2}, 0.3);
  impacts.step(1e-3);
  CHECK(impacts.points.v[0].z == fixtures::relative(-2 * 0.3 / (0.3 + 0.7), 1e-5));  // 1e-6 is what passes agree to
  CHECK(loose.v[4].z == fixtures::relative(-2 * 0.3 / (0.3 + 0.7), 1e-5));
}

TEST_CASE("external structure: the work of contact is the energy that the vertices gain") {
  const Panels panels = sheet(2);
  Loose loose{panels.vertices, std::vector<Vec3d>(9, Vec3d{0, 0, -0.4}), std::vector<double>(9, 0.7)};
  ExternalStructure structure(loose.solver(), loose.m, panels.vertices);
  Impacts impacts(structure, open_surface(panels), 0);
  impacts.add({0.1, 0.12, 1e-9}, {0, 0, -2}, 0.3);
  const double before = loose.kinetic_energy();
  impacts.step(1e-3);
  CHECK(impacts.work == fixtures::relative(loose.kinetic_energy() - before, 1e-9));
}

TEST_CASE("external structure: with springs that act in the same steps, the work of contact is the energy that vertices and springs gain") {
  const Panels panels = sheet(2);
  const std::size_t count = panels.vertices.size();
  const double stiffness = 2e4, dt = 1e-4;  // [N/m], [s]; ω dt = 0.017
  Loose loose{panels.vertices, std::vector<Vec3d>(count), std::vector<double>(count, 0.7)};
  StructureSolver solver = loose.solver();
  std::vector<Vec3d> stretched(count);  // at the beginning of the step
  solver.advance = [&, free = solver.advance](const Step& step) {
    for (std::size_t i = 0; i < count; ++i) {
      stretched[i] = loose.x[i] - panels.vertices[i];
      loose.v[i] -= (step.dt * stiffness / loose.m[i]) * stretched[i];
    }
    return free(step);
  };
  ExternalStructure structure(solver, loose.m, panels.vertices);
  Impacts impacts(structure, open_surface(panels), 0);
  impacts.add({0.1, 0.12, 1e-9}, {0, 0, -2}, 0.3);
  for (int step = 0; step < 100; ++step) impacts.step(dt);  // the springs push the point back during some of them
  double energy = loose.kinetic_energy();                   // with ½ k u(t0)·u(t1), symplectic Euler conserves the sum exactly
  for (std::size_t i = 0; i < count; ++i) energy += 0.5 * stiffness * dot(stretched[i], loose.x[i] - panels.vertices[i]);
  CHECK(energy > 0.1);
  CHECK(impacts.work == fixtures::relative(energy, 1e-6));  // passes agree to 1e-6
}

TEST_CASE("external structure: masses that do not fit are refused with a sentence") {
  const Panels panels = sheet(2);
  Loose loose{panels.vertices, std::vector<Vec3d>(9), std::vector<double>(9, 0.7)};
  CHECK_THROWS_WITH_AS(ExternalStructure(loose.solver(), std::vector<double>(8, 1.0), panels.vertices), doctest::Contains("8 masses, but the surface has 9"),
                       InputError);
  loose.m[3] = 0;
  CHECK_THROWS_WITH_AS(ExternalStructure(loose.solver(), loose.m, panels.vertices), doctest::Contains("mass of vertex 3"), InputError);
}
