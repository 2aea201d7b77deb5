#include "perimpact/materials/ordinary_state/plastic_force.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/ices.hpp"

using namespace perimpact;
using fixtures::compressive;
using fixtures::draw_strains;
using fixtures::every_ice;
using fixtures::ice;
using fixtures::ice_setup;
using fixtures::IceOptions;
using fixtures::modulus;
using fixtures::NamedIce;
using fixtures::Points;
using fixtures::spacing;
using fixtures::strain_uniformly;

namespace {

/// The energy by a loop over all pairs of particles.
struct PairEnergy {
  const Body& body;
  std::vector<std::size_t> slots;
  std::vector<Vec3d> X, x;
  std::vector<SymmetricTensor> strain;

  PairEnergy(const Body& of, std::vector<SymmetricTensor> strains)
      : body(of), slots(of.particles.slot_of().begin(), of.particles.slot_of().end()), strain(std::move(strains)) {
    for (const std::size_t slot : slots) X.push_back(body.particles.reference(slot)), x.push_back(body.particles.position.at(slot));
  }
  double factor(std::size_t i, std::size_t j, const Vec3d& n, bool stretch) const {
    const CorrectionFactors& correction = body.internal.plastic()->correction();
    if (correction.kind() == CorrectionKind::none) return 1;
    if (correction.kind() == CorrectionKind::volume) return 1 / (correction.volume().component(0)[slots[i]] + correction.volume().component(0)[slots[j]]);
    const VectorArray& g = stretch ? correction.stretch() : correction.dilatation();
    double sum = 0;
    for (std::size_t p = 0; p < 3; ++p) sum += n[p] * n[p] * 0.5 * (g.at(slots[i])[p] + g.at(slots[j])[p]);
    return sum;
  }
  static double along(const SymmetricTensor& a, const Vec3d& n) {
    return a[0] * n.x * n.x + a[1] * n.y * n.y + a[2] * n.z * n.z + 2 * (a[3] * n.x * n.y + a[4] * n.y * n.z + a[5] * n.x * n.z);
  }
  double energy() const {
    const OrdinaryState& law = body.internal.plastic()->law();
    const double delta = body.family.horizon();
    double total = 0;
    for (std::size_t i = 0; i < X.size(); ++i) {
      double theta = 0, bonds = 0;
      for (std::size_t j = 0; j < X.size(); ++j) {
        const Vec3d xi = X[j] - X[i];
        const double length = norm(xi), size = 0.5 * (body.particles.size_of(slots[i]) + body.particles.size_of(slots[j]));
        if (j == i || length >= delta + size / 2 * (1 - 1e-9)) continue;
        const double v = std::min(1.0, (delta + size / 2 - length) / size) * body.particles.volume(slots[j]);
        const Vec3d n = xi / length;
        const double s = 0.5 * (squared_norm(x[j] - x[i]) / squared_norm(xi) - 1) - 0.5 * (along(strain[i], n) + along(strain[j], n));
        theta += law.d() * law.weights(length).dilatation * s * v * factor(i, j, n, false);
        bonds += law.b() * law.weights(length).stretch * s * s * v * factor(i, j, n, true);
      }
      total += (law.a() * theta * theta + bonds) * body.particles.volume(slots[i]);
    }
    return total;
  }
};

std::vector<double> forces(const Body& body) {
  std::vector<double> all;
  for (const std::uint32_t slot : body.particles.slot_of())
    for (std::size_t c = 0; c < 3; ++c) all.push_back(body.particles.force_density.component(c)[slot]);
  return all;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = fixtures::larger(most, std::fabs(value));
  return most;
}

std::size_t middle_slot(const Body& body) {
  std::size_t nearest = 0;
  double least = 1e300;
  for (const std::uint32_t slot : body.particles.slot_of())
    if (squared_norm(body.particles.reference(slot)) < least) least = squared_norm(body.particles.reference(slot)), nearest = slot;
  return nearest;
}

}  // namespace

TEST_CASE("plastic force: force and stress are the gradients of the energy that a loop over all pairs gives, on every kind of points") {
  for (const NamedIce& one : every_ice({0.6, 0.5, 0.4})) {
    CAPTURE(one.name);
    Body body = ice(one.options);
    fixtures::shake(body, 1e-3 * spacing);
    const std::vector<SymmetricTensor> strains = draw_strains(body, 1e-3);
    PairEnergy oracle(body, strains);
    const double reported = body.internal.evaluate_with_energy(body.particles, body.family);
    CHECK(reported == fixtures::relative(oracle.energy(), 1e-11));  // the same sum in another order
    const auto force = forces(body);
    const std::size_t count = oracle.x.size();
    for (const std::size_t i : {std::size_t{0}, count / 3 / 3 * 3, count - 1}) {  // a corner, an inner one that is plastic, the other corner
      const double volume = body.particles.volume(oracle.slots[i]);
      for (std::size_t c = 0; c < 3; ++c) {
        const double h = 1e-6 * spacing;  // central difference of a quartic: error (h/1e-3 Δ)², rounding 1e-13/1e-3; both below 1e-5
        double& moved = oracle.x[i][c];
        const double at = moved;
        moved = at + h;
        const double above = oracle.energy();
        moved = at - h;
        const double below = oracle.energy();
        moved = at;
        CHECK(std::fabs(force[3 * i + c] + (above - below) / (2 * h) / volume) <= 1e-5 * largest(force));
      }
      if (!body.internal.plastic()->is_stress_known(oracle.slots[i])) continue;
      const SymmetricTensor stress = body.internal.plastic()->stress(oracle.slots[i]);
      for (std::size_t c = 0; c < 6; ++c) {
        const double h = 1e-5;  // of a quadratic energy: rounding 1e-13/1e-2 alone
        double& component = oracle.strain[i][c];
        const double at = component;
        component = at + h;
        const double above = oracle.energy();
        component = at - h;
        const double below = oracle.energy();
        component = at;
        const double both = c < 3 ? 1 : 2;  // ε_xy and ε_yx
        CHECK(stress[c] == fixtures::absolute(-(above - below) / (2 * h) / volume / both, 1e-7 * modulus * 1e-3, "Pa"));
      }
      CHECK(body.internal.plastic()->pressure(oracle.slots[i]) == fixtures::absolute(pressure_of(stress), 1e-12 * modulus, "Pa"));
    }
  }
}

TEST_CASE("plastic force: without plastic strain it is the ordinary material, up to the square of the strain") {
  for (const double nu : {0.25, 0.33}) {
    Body plastic = ice({.poissons_ratio = nu}), elastic = ice({.poissons_ratio = nu, .is_plastic = false});
    for (Body* body : {&plastic, &elastic}) {
      strain_uniformly(*body, {1e-5, -2e-5, 3e-5, 1e-5, 0, 2e-5});
      body->internal.evaluate(body->particles, body->family);
    }
    const auto a = forces(plastic), b = forces(elastic);
    // engineering and Green's strain differ by half of their square: at 5e-5 by 3e-5 of the strain, on faces where forces do not cancel
    for (std::size_t n = 0; n < a.size(); ++n) CHECK(std::fabs(a[n] - b[n]) <= 1e-4 * largest(b));
  }
}

TEST_CASE("plastic force: the wide kernel gives what the one-particle kernel gives, to the last bit, and so do any number of threads") {
  for (const NamedIce& one : every_ice({1.7, 0.6, 0.5})) {
    CAPTURE(one.name);
    IceOptions options = one.options;
    options.critical_stretch = 2e-3;
    const auto run = [&](bool scalar) {
      Body body = ice(options);
      draw_strains(body, 3e-4);
      for (int step = 1; step <= 5; ++step) {
        const double e = (step < 4 ? 1 : -2) * step * 1e-3;  // at last in tension
        strain_uniformly(body, {-e, 0.5 * e, -0.2 * e, 0.1 * e, 0, 0.3 * e});
        fixtures::shake(body, 2e-4 * spacing, static_cast<unsigned>(step));
        if (scalar)
          body.internal.evaluate_scalar(body.particles, body.family, 1e-4);
        else
          body.internal.evaluate(body.particles, body.family, 1e-4);
      }
      return body;
    };
    const Body wide = run(false), narrow = run(true);
    CHECK(forces(wide) == forces(narrow));
    CHECK(wide.internal.broken_bonds() == narrow.internal.broken_bonds());
    CHECK(wide.internal.broken_bonds() > 0);
    const auto same_state = [&](const Body& other) {
      double yielded = 0;
      for (const std::uint32_t slot : wide.particles.slot_of()) {
        CHECK(wide.internal.plastic()->plastic_strain(slot) == other.internal.plastic()->plastic_strain(slot));
        CHECK(wide.internal.plastic()->pressure(slot) == other.internal.plastic()->pressure(slot));
        yielded += wide.internal.plastic()->equivalent_strain(slot) > 0 ? 1 : 0;
      }
      CHECK(yielded > 0.1 * static_cast<double>(wide.particles.size()));
    };
    same_state(narrow);
    const fixtures::Threads with_five(5);
    const Body threaded = run(false);
    CHECK(forces(wide) == forces(threaded));
    CHECK(wide.internal.plastic_dissipation() == threaded.internal.plastic_dissipation());
    CHECK(wide.internal.fracture_energy() == threaded.internal.fracture_energy());
    same_state(threaded);
  }
}

TEST_CASE("plastic force: forces and moments sum to zero with any plastic strain") {
  for (const NamedIce& one : every_ice({0.7, 0.6, 0.5})) {
    CAPTURE(one.name);
    Body body = ice(one.options);
    fixtures::shake(body, 1e-3 * spacing);
    draw_strains(body, 1e-2);
    body.internal.evaluate(body.particles, body.family);
    Vec3d sum{}, moment{};
    double scale = 0;
    for (const std::uint32_t slot : body.particles.slot_of()) {
      const Vec3d force = body.particles.volume(slot) * body.particles.force_density.at(slot);
      sum += force, moment += cross(body.particles.position.at(slot), force), scale += norm(force);
    }
    // each pair is exactly opposite and along its bond; what is left is rounding of sums of up to 178 terms, each below 1e-15 of the whole
    CHECK(norm(sum) <= 1e-14 * scale);
    CHECK(norm(moment) <= 1e-14 * scale * 0.4);
  }
}

TEST_CASE("plastic force: uniform strain under pressure leads to the yield surface and along it, in every direction of pressure and shear") {
  const std::pair<const char*, SymmetricTensor> paths[] = {{"hydrostatic", {-1, -1, -1, 0, 0, 0}},
                                                           {"confined", {-1, 0, 0, 0, 0, 0}},
                                                           {"uniaxial stress", {-1, 0.25, 0.25, 0, 0, 0}},
                                                           {"pressed and sheared in a plane of the lattice", {-0.2, -0.2, -0.2, 0.5, 0, 0}},
                                                           {"sheared across the planes", {-0.5, 0.2, -0.1, 0.2, 0.3, -0.1}}};
  for (const double nu : {0.25, 0.33})
    for (const auto& path : paths) {
      const SymmetricTensor& direction = path.second;
      CAPTURE(path.first);
      CAPTURE(nu);
      Body body = ice({.size = {1.3, 1.3, 1.3}, .poissons_ratio = nu, .correction = SurfaceCorrection::none});
      const PlasticForce& force = *body.internal.plastic();
      const YieldEllipse& ellipse = force.plasticity().ellipse;
      const std::size_t middle = middle_slot(body);  // its neighbours have whole families, and the same strain
      const auto strained = [&](double size) {
        SymmetricTensor e = direction;
        for (double& component : e) component *= size;
        strain_uniformly(body, e);
        body.internal.evaluate(body.particles, body.family);
      };
      double size = 1e-4;
      while (force.equivalent_strain(middle) == 0) strained(size *= 1.02);
      // on with 1e-6 a step: the stress before it returns is a step of about 2 µ 1e-6 outside, in J2 2/q of that
      for (int step = 0; step < 40; ++step) strained(size += 1e-6);
      const SymmetricTensor stress = force.stress(middle);
      const double p = pressure_of(stress), gradient = 2 * second_invariant(stress) + p * std::fabs(ellipse.slope(p));  // σ:∂f/∂σ: 1 % of it is 1 % of stress
      // on the surface but for the strain of one step, 2 µ 1e-6 = 1.4 kPa, less than 0.1 % of these stresses; flow of neighbours lags as much
      CHECK(ellipse.function(stress) == fixtures::absolute(0, 0.002 * gradient, "Pa2"));
      CHECK(force.equivalent_strain(middle) > 3e-6);
    }
}

TEST_CASE("plastic force: under tension no particle yields and bonds break where those of the ordinary material do") {
  for (const double stretch : {2.9e-4, 3.1e-4}) {
    IceOptions options{.critical_stretch = 3e-4};
    Body plastic = ice(options);
    options.is_plastic = false;
    Body elastic = ice(options);
    for (Body* body : {&plastic, &elastic}) {
      strain_uniformly(*body, {stretch, -0.25 * stretch, -0.25 * stretch, 0, 0, 0});
      body->internal.evaluate(body->particles, body->family);
    }
    CHECK(plastic.internal.broken_bonds() == elastic.internal.broken_bonds());
    CHECK((plastic.internal.broken_bonds() > 0) == (stretch > 3e-4));
    for (const std::uint32_t slot : plastic.particles.slot_of()) CHECK(plastic.internal.plastic()->equivalent_strain(slot) == 0);
  }
}

TEST_CASE("plastic force: pulled from all sides far beyond the closed end of the ellipse, nothing flows") {
  Body body = ice();
  for (const double strain : {1e-3, 2e-3}) {  // p of -2.4 and -4.8 MPa, f > 0
    strain_uniformly(body, {strain, strain, strain, 0, 0, 0});
    body.internal.evaluate(body.particles, body.family);
  }
  const PlasticForce& force = *body.internal.plastic();
  for (const std::uint32_t slot : body.particles.slot_of()) {
    CHECK(force.plasticity().ellipse.limit(force.pressure(slot)) < 0);
    CHECK(force.equivalent_strain(slot) == 0);
  }
}

TEST_CASE("plastic force: under pressure the limit of a bond rises by 3/4 p/E, so that shear breaks it at the principal stress s_c E") {
  // pressed from all sides with p, then strained until the first bond breaks
  const double critical = 3e-4, bulk_strain = 1e-4;  // p = 2/3 E 3e-4 = 0.36 MPa, far below yielding
  double at = 0;
  Body body = ice({.size = {1.3, 1.3, 1.3}, .correction = SurfaceCorrection::none, .critical_stretch = critical});
  const PlasticForce& force = *body.internal.plastic();
  const std::size_t middle = middle_slot(body);
  const auto middle_has_all = [&] { return body.family.damage(middle) == 0; };
  const double compression = -3 * bulk_strain;  // along y and z
  while (middle_has_all()) {
    at += 1e-6;
    strain_uniformly(body, {at, compression, compression, 0, 0, 0});
    body.internal.evaluate(body.particles, body.family);
    body.internal.evaluate(body.particles, body.family);  // the limit is that of the pressure before
  }
  // p of the lattice, whose bulk modulus is 2/3 E within 1 %
  const double p = force.moduli().bulk * -(at + 2 * compression);
  CHECK(at == fixtures::relative(critical + 0.75 * p / modulus, 0.01));  // steps of 1e-6, 0.3 %
  CHECK(at > 1.2 * critical);
}

TEST_CASE("plastic force: beyond its failure strain ice with a friction_angle carries shear in proportion to the pressure, without it as before") {
  const double angle = std::acos(-1.0) / 6;
  const SymmetricTensor path{-1, 0.45, 0.45, 0.2, 0.3, -0.1};
  Body crushed = ice({.size = {1.3, 1.3, 1.3}, .correction = SurfaceCorrection::none, .critical_stretch = 1, .failure_pressure = 0.2, .friction_angle = angle});
  Body cohesive = ice({.size = {1.3, 1.3, 1.3}, .correction = SurfaceCorrection::none, .critical_stretch = 1, .failure_pressure = 0.2});
  const std::size_t middle = middle_slot(crushed);
  double size = 0;
  const auto strained = [&](double by) {
    size += by;
    SymmetricTensor e = path;
    for (double& component : e) component *= size;
    for (Body* body : {&crushed, &cohesive}) {
      strain_uniformly(*body, e);
      body->internal.evaluate(body->particles, body->family);
    }
  };
  const auto have_failed = [&] { return crushed.internal.plastic()->has_lost_cohesion(middle) && cohesive.internal.plastic()->has_lost_cohesion(middle); };
  while (!have_failed() && size < 0.1) strained(1e-4);
  REQUIRE(have_failed());
  for (int step = 0; step < 300; ++step) strained(1e-6);
  const SymmetricTensor weak = crushed.internal.plastic()->stress(middle), strong = cohesive.internal.plastic()->stress(middle);
  const double p = pressure_of(weak);
  CHECK(p > 0);
  // outside by what a step of strain adds, 2 µ 1e-6, below 1 % of a stress of 0.2 MPa
  CHECK(second_invariant(weak) == fixtures::relative(residual_of_friction_angle(angle) * p * p, 0.03));
  CHECK(cohesive.internal.plastic()->plasticity().ellipse.function(strong) == fixtures::absolute(0, 0.01 * second_invariant(strong), "Pa2"));
  CHECK(second_invariant(strong) > 1.5 * second_invariant(weak));
}

TEST_CASE("plastic force: a particle beyond its failure strain keeps its bonds under pressure, and loses them in tension before others do") {
  // nearly at constant volume dilatant flow brings the pressure to the top of the ellipse, 0.48 p₂, where ε_f is 0.01 or, at N = 5, 20
  Body failed = ice({.critical_stretch = 5e-4, .failure_pressure = 0.48}), whole = ice({.critical_stretch = 5e-4, .failure_pressure = 5});
  double e = 0;
  const auto strained = [&](double along) {
    for (Body* body : {&failed, &whole}) {
      strain_uniformly(*body, {along, 0.48 * e, 0.48 * e, 0, 0, 0});
      body->internal.evaluate(body->particles, body->family);
    }
  };
  for (; e < 0.03; e += e < 2e-3 ? 2e-5 : 2e-4) strained(-e);
  for (const std::uint32_t slot : failed.particles.slot_of()) CHECK(failed.internal.plastic()->has_lost_cohesion(slot));
  for (const std::uint32_t slot : whole.particles.slot_of()) CHECK(!whole.internal.plastic()->has_lost_cohesion(slot));
  const std::size_t before = failed.internal.broken_bonds();
  CHECK(before == whole.internal.broken_bonds());
  CHECK(before < failed.family.initial_bonds() / 10);
  // let go, until the first tenth of the bonds parts; s_c, 50 steps of strain, is what the others still carry
  double along = -e;
  for (int step = 0; step < 1000 && failed.internal.broken_bonds() < before + failed.family.initial_bonds() / 10; ++step) strained(along += 1e-5);
  CHECK(failed.internal.broken_bonds() > before + failed.family.initial_bonds() / 10);
  CHECK(whole.internal.broken_bonds() < before + whole.family.initial_bonds() / 20);  // of faces, where the strain is not uniform
}
