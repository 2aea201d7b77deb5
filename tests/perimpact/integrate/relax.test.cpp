#include "perimpact/integrate/relax.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/boundary_conditions/scene.hpp"

using namespace perimpact;

namespace {

/// Bodies as Relaxation takes them; there is one.
struct RelaxedBody {
  std::vector<Body> bodies;
  std::vector<BoundaryConditions> boundary_conditions;

  RelaxedBody(const BodySetup& setup, Body body, const fixtures::Regions& regions) {
    boundary_conditions.emplace_back(setup, elastic_of(setup), body.particles, fixtures::slots_of(body.particles, regions));
    bodies.push_back(std::move(body));
  }
  Body& body() { return bodies.front(); }
  const ReactionLedger& account(std::size_t k) const { return boundary_conditions.front().all()[k].account(); }

  struct How {
    double tolerance = 1e-4;  // enough for most of these
    int max_iterations = 20000;
    double dt = 1;  // [s]
    double safety = Relaxation::default_safety;
  };
  Relaxed to(double time, const How& how) {
    Relaxation relaxation({.tolerance = how.tolerance, .max_iterations = how.max_iterations}, bodies, how.dt, how.safety);
    energy = relaxation.relax(bodies, boundary_conditions, 1, time, {}).value().front();
    return relaxation.latest();
  }
  double energy = 0;  // [J]
};

/// What x of a K x = b is, by Gaussian elimination with pivots.
std::vector<double> solve(std::vector<std::vector<double>> K, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < n; ++r)
      if (std::fabs(K[r][i]) > std::fabs(K[pivot][i])) pivot = r;
    std::swap(K[i], K[pivot]), std::swap(b[i], b[pivot]);
    for (std::size_t r = i + 1; r < n; ++r) {
      const double factor = K[r][i] / K[i][i];
      for (std::size_t c = i; c < n; ++c) K[r][c] -= factor * K[i][c];
      b[r] -= factor * b[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t c = i + 1; c < n; ++c) b[i] -= K[i][c] * b[c];
    b[i] /= K[i][i];
  }
  return b;
}

/// Displacements under a body force with the first layer of particles in x constrained, from the stiffness by differences of the forces.
std::vector<Vec3d> direct_solution(Body body, const Vec3d& force_density) {
  const double step = 1e-6 * body.particles.spacing();
  double first = body.particles.reference(body.particles.slot_of()[0]).x;
  for (const std::uint32_t slot : body.particles.slot_of()) first = std::min(first, body.particles.reference(slot).x);
  struct Freedom {
    std::size_t slot, axis;
  };
  std::vector<Freedom> free;
  for (const std::uint32_t slot : body.particles.slot_of())
    for (std::size_t axis = 0; axis < (body.particles.is_plane() ? 2u : 3u); ++axis)
      if (body.particles.reference(slot).x > first + 0.5 * body.particles.spacing()) free.push_back({slot, axis});
  const auto forces = [&] {
    body.internal.evaluate(body.particles, body.family);
    std::vector<double> all;
    for (const Freedom& f : free) all.push_back(body.particles.force_density.component(f.axis)[f.slot]);
    return all;
  };
  std::vector<std::vector<double>> K(free.size(), std::vector<double>(free.size()));
  std::vector<double> load;
  for (std::size_t c = 0; c < free.size(); ++c) {
    double& x = body.particles.position.component(free[c].axis)[free[c].slot];
    const double rest = x;
    x = rest + step;
    const std::vector<double> further = forces();
    x = rest - step;
    const std::vector<double> nearer = forces();
    x = rest;
    for (std::size_t r = 0; r < free.size(); ++r) K[r][c] = (nearer[r] - further[r]) / (2 * step);
    load.push_back(force_density[free[c].axis]);
  }
  const std::vector<double> u = solve(std::move(K), std::move(load));
  std::vector<Vec3d> displacements(body.particles.slots());
  for (std::size_t k = 0; k < free.size(); ++k) displacements[free[k].slot][free[k].axis] = u[k];
  return displacements;
}

double largest(const Particles& particles, const std::function<Vec3d(std::size_t)>& vector) {
  double most = 0;
  for (const std::uint32_t slot : particles.slot_of()) most = fixtures::larger(most, norm(vector(slot)));
  return most;
}

/// A bar along x of 12 layers of 1 mm, its ends constrained in x, the right one displaced by `displacement`.
BodySetup pulled_bar(double displacement, std::optional<double> critical_stretch = {}) {
  BodySetup setup = fixtures::body_setup({.size = {0.012, 0.003, 0.003}, .critical_stretch = critical_stretch});
  DisplacementSetup course;
  course.times = {0, 1}, course.displacements = {0, displacement};
  setup.boundary_conditions = {{"grip", FixedSetup{.particle_set = "left", .directions = {}}}, {"pull", PrescribedSetup{.particle_set = "right", .x = course}}};
  return setup;
}
const fixtures::Regions ends = {{"left", [](const Vec3d& X) { return X.x < -0.005; }}, {"right", [](const Vec3d& X) { return X.x > 0.005; }}};

}  // namespace

TEST_CASE("relax: in a block under tension strain and contraction are those of the classical solution (Madenci and Oterkus 2014, section 8.5)") {
  const fixtures::Threads with_one(1);
  constexpr double spacing = 0.02, traction = 200e6;  // [m] [Pa]
  BodySetup setup = fixtures::body_setup({.size = {1, 0.1, 0.1}, .spacing = spacing});
  setup.material = OrdinaryStateSetup{{.youngs_modulus = 200e9, .poissons_ratio = 0.25, .density = 7850}};
  setup.boundary_conditions = {{"clamp", FixedSetup{.particle_set = "left", .directions = {}}},
                               {"pull", PressureSetup{.particle_set = "right", .face = Choice{face_words, 0}, .value = -traction}}};
  RelaxedBody block(setup, make_body(setup),
                    {{"left", [](const Vec3d& X) { return X.x < -0.5 + 3 * spacing; }}, {"right", [](const Vec3d& X) { return X.x > 0.5 - spacing; }}});
  block.to(1, {});
  const Particles& particles = block.body().particles;
  const auto at = [&](double x, double y) {
    for (const std::uint32_t slot : particles.slot_of())
      if (const Vec3d X = particles.reference(slot); norm(X - Vec3d{x, y, 0}) < 0.1 * spacing) return particles.displacement(slot);
    return Vec3d{};
  };
  // u_x = 0.001 x: between two places away from the ends, where the clamp and the load are not felt. The surface correction leaves a bar of
  // five by five particles within 1 % of its stiffness.
  CHECK((at(0.23, 0).x - at(-0.23, 0).x) / 0.46 == fixtures::relative(0.001, 0.01));
  // u_y = -0.00025 y. Layers at the surface contract more than those inside, the whole bar by 4 % too much.
  CHECK(at(0.01, 0.04).y == fixtures::relative(-0.00025 * 0.04, 0.06));
  CHECK(block.account(0).force().x == fixtures::relative(-traction * 0.01, 1e-3));  // the residual is 1e-4 of forces
  CHECK(block.account(1).force().x == fixtures::relative(traction * 0.01, 1e-12));
}

TEST_CASE("relax: the equilibrium is that of the stiffness matrix, for any material, points and dimension") {
  const fixtures::Threads with_one(1);
  using fixtures::Model;
  using fixtures::Points;
  const fixtures::BodyOptions all[] = {{},
                                       {.poissons_ratio = 0.4},
                                       {.poissons_ratio = 0.3, .model = Model::linear_solid, .points = Points::shaken},
                                       {.poissons_ratio = 0.1, .plane = Plane::strain},
                                       {.poissons_ratio = 0.3, .model = Model::correspondence},
                                       {.model = Model::bond_based, .plane = Plane::stress, .points = Points::listed}};
  for (fixtures::BodyOptions options : all) {
    options.size = {0.006, 0.003, 0.003};
    BodySetup setup = fixtures::body_setup(options);
    const Vec3d force_density{2e8, -1e8, 0};  // strains of 1e-5: what is not linear is as small
    double first = 1;
    Body body = fixtures::body(options);
    for (const std::uint32_t slot : body.particles.slot_of()) first = std::min(first, body.particles.reference(slot).x);
    setup.boundary_conditions = {{"clamp", FixedSetup{.particle_set = "left", .directions = {}}}, {"weight", BodyForceSetup{.force_density = force_density}}};
    const std::vector<Vec3d> expected = direct_solution(fixtures::body(options), force_density);
    const double spacing = body.particles.spacing();
    RelaxedBody bar(setup, std::move(body), {{"left", [=](const Vec3d& X) { return X.x <= first + 0.5 * spacing; }}});
    bar.to(1, {.tolerance = 1e-8});
    const Particles& particles = bar.body().particles;
    const double size = largest(particles, [&](std::size_t slot) { return expected[slot]; });
    CAPTURE(static_cast<int>(options.model));
    CAPTURE(options.poissons_ratio);
    CHECK(largest(particles, [&](std::size_t slot) { return particles.displacement(slot) - expected[slot]; }) <= 1e-4 * size);
  }
}

TEST_CASE("relax: the equilibrium depends neither on the densities nor on the length of the increment, the iterations on the densities only") {
  const fixtures::Threads with_one(1);
  const auto relaxed = [](double dt, double safety, long& iterations) {
    BodySetup setup = pulled_bar(1e-6);
    RelaxedBody bar(setup, make_body(setup), ends);
    iterations = bar.to(1, {.tolerance = 1e-9, .dt = dt, .safety = safety}).iterations;
    return std::pair(bar.energy, bar.account(1).force().x);
  };
  long usual, short_increment, heavy;
  const auto state = relaxed(1, Relaxation::default_safety, usual), same = relaxed(1e-3, Relaxation::default_safety, short_increment),
             slow = relaxed(1, 3, heavy);
  CHECK(usual == short_increment);
  CHECK(heavy > usual);
  CHECK(same.first == fixtures::relative(state.first, 1e-9));  // rounding of other numbers
  CHECK(slow.first == fixtures::relative(state.first, 1e-7));  // what the tolerance leaves
  CHECK(slow.second == fixtures::relative(state.second, 1e-7));
}

TEST_CASE("relax: the work of prescribed displacements is the elastic energy, also over several increments") {
  const fixtures::Threads with_one(1);
  BodySetup setup = pulled_bar(1e-6);
  RelaxedBody bar(setup, make_body(setup), ends);
  for (const double time : {0.2, 0.7, 1.0}) {
    bar.to(time, {.tolerance = 1e-6});
    // forces are right to the tolerance, and the bar is linear but for its strain of 1e-4
    CHECK(bar.boundary_conditions.front().work() == fixtures::relative(bar.energy, 2e-4));
  }
}

TEST_CASE("relax: bonds break in equilibrium only, not by transient waves") {
  const fixtures::Threads with_one(1);
  constexpr double critical = 1e-3;
  const double all = 0.011 * critical;  // [m] of the longer bonds between the ends, evenly stretched
  BodySetup setup = pulled_bar(0.6 * all, critical);
  RelaxedBody whole(setup, make_body(setup), ends);
  whole.to(1, {});
  CHECK(whole.body().internal.broken_bonds() == 0);

  setup = pulled_bar(3 * all, critical);
  RelaxedBody torn(setup, make_body(setup), ends);
  torn.to(1, {});
  CHECK(torn.body().internal.broken_bonds() > 0);
  CHECK(std::fabs(torn.account(1).force().x) < 1e-3 * std::fabs(whole.account(1).force().x));  // its halves hang on their grips
}

TEST_CASE("relax: an unconstrained body has no equilibrium, and the error gives the increment and the residual") {
  const fixtures::Threads with_one(1);
  BodySetup setup = fixtures::body_setup({.size = {0.004, 0.003, 0.003}});
  setup.boundary_conditions = {{"weight", BodyForceSetup{.force_density = {0, 0, -8e4}}}};
  RelaxedBody falling(setup, make_body(setup), {});
  std::string sentence;
  try {
    falling.to(0.5, {.max_iterations = 20});
  } catch (const fccda::RunError& error) {
    sentence = error.what();
  }
  CHECK(sentence.starts_with("Increment 1 (t = 0.5 s) is not in equilibrium after 20 iterations: the residual is "));
  CHECK(
      sentence.ends_with(", but the tolerance is 0.0001. If a part is unconstrained or has broken off, there is no equilibrium; otherwise increase "
                         "max_iterations, or use smaller increments."));
}

TEST_CASE("relax: one and two threads yield the bitwise identical state, with bond failure on the way") {
  const auto positions = [](int threads) {
    const fixtures::Threads with_several(threads);
    BodySetup setup = pulled_bar(2.5e-5, 1e-3);
    RelaxedBody bar(setup, make_body(setup), ends);
    bar.to(1, {.tolerance = 0.02});
    std::vector<Vec3d> all;
    for (const std::uint32_t slot : bar.body().particles.slot_of()) all.push_back(bar.body().particles.position.at(slot));
    return std::pair(all, bar.body().internal.broken_bonds());
  };
  const auto one = positions(1), two = positions(2);
  CHECK(one.second > 0);
  CHECK(one.first == two.first);
  CHECK(one.second == two.second);
}
