#include "perimpact/force/internal_force.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "fccda/core/parallel.hpp"
#include "perimpact/bodies.hpp"

using namespace perimpact;
using fixtures::body;
using fixtures::BodyOptions;

namespace {

/// The elastic energy by a loop over all pairs of particles: shares nothing with the kernels but the constants a, b, d.
struct PairSums {
  const Body& body;
  std::vector<Vec3d> X, x;
  std::vector<double> theta;

  explicit PairSums(const Body& of) : body(of) {
    for (const std::uint32_t slot : body.particles.slot_of()) X.push_back(body.particles.reference(slot)), x.push_back(body.particles.position.at(slot));
  }
  /// f(i, j, ξ, partial volume, G, G_θ) for all bonds of i
  template <class F>
  void bonds_of(std::size_t i, const F& f) const {
    const double spacing = body.particles.lattice().spacing, delta = body.family.stencil().horizon();
    for (std::size_t j = 0; j < X.size(); ++j) {
      const Vec3d xi = X[j] - X[i];
      const double length = norm(xi);
      if (j == i || length >= delta + spacing / 2 * (1 - 1e-9)) continue;
      const double v = std::min(1.0, (delta + spacing / 2 - length) / spacing) * spacing * spacing * spacing;
      f(j, xi, v, factor(i, j, xi, true), factor(i, j, xi, false));
    }
  }
  double factor(std::size_t i, std::size_t j, const Vec3d& xi, bool stretch) const {
    const auto& correction = body.internal.correction();
    const auto slots = body.particles.slot_of();
    if (correction.kind() == SurfaceCorrection::none) return 1;
    if (correction.kind() == SurfaceCorrection::volume) return 1 / (correction.volume().component(0)[slots[i]] + correction.volume().component(0)[slots[j]]);
    const VectorArray& g = stretch ? correction.stretch() : correction.dilatation();
    double sum = 0;
    for (std::size_t p = 0; p < 3; ++p) sum += xi[p] * xi[p] / squared_norm(xi) * 0.5 * (g.at(slots[i])[p] + g.at(slots[j])[p]);
    return sum;
  }
  double stretch(std::size_t i, std::size_t j) const { return norm(x[j] - x[i]) / norm(X[j] - X[i]) - 1; }
  double energy() {
    const OrdinaryState& m = body.internal.material();
    const double delta = body.family.stencil().horizon();
    double total = 0;
    for (std::size_t i = 0; i < X.size(); ++i) {
      double theta_i = 0, bonds = 0;
      bonds_of(i, [&](std::size_t j, const Vec3d& xi, double v, double g, double g_theta) {
        const double s = stretch(i, j);
        theta_i += m.d() * delta * s * v * g_theta;
        bonds += m.b() * delta * s * s * norm(xi) * v * g;
      });
      total += (m.a() * theta_i * theta_i + bonds) * body.particles.volume();
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
  for (const double value : values) most = std::max(most, std::fabs(value));
  return most;
}

const SurfaceCorrection all_corrections[] = {SurfaceCorrection::none, SurfaceCorrection::energy, SurfaceCorrection::volume};
constexpr double all_ratios[] = {0.2, 0.25, 0.3, 0.4};

}  // namespace

TEST_CASE("internal force: the wide kernel and the one-particle kernel agree for every material and correction") {
  for (const double nu : all_ratios)
    for (const SurfaceCorrection correction : all_corrections) {
      CAPTURE(nu);
      Body wide = body({.poissons_ratio = nu, .correction = correction}), scalar = body({.poissons_ratio = nu, .correction = correction});
      fixtures::shake(wide, 1e-6), fixtures::shake(scalar, 1e-6);
      wide.internal.evaluate(wide.particles, wide.family);
      scalar.internal.evaluate_scalar(scalar.particles, scalar.family);
      const auto a = forces(wide), b = forces(scalar);
      // lengths are rounded differently by a few 1e-16; a bond of strain 1e-3 turns that into 1e-12 of its force, a family into less
      const double tolerance = 1e-12 * largest(b);
      for (std::size_t n = 0; n < a.size(); ++n) CHECK(std::fabs(a[n] - b[n]) <= tolerance);
      CHECK(largest(b) > 0);
    }
}

TEST_CASE("internal force: it is the gradient of the energy that a loop over all pairs gives, for every material and correction") {
  for (const double nu : all_ratios)
    for (const SurfaceCorrection correction : all_corrections) {
      CAPTURE(nu);
      CAPTURE(static_cast<int>(correction));
      Body solid = body({.size = {0.006, 0.005, 0.004}, .poissons_ratio = nu, .correction = correction});
      fixtures::shake(solid, 1e-5);
      const double reported = solid.internal.evaluate_with_energy(solid.particles, solid.family);
      PairSums sums(solid);
      const double energy = sums.energy();
      CHECK(reported == doctest::Approx(energy).epsilon(1e-11));  // the same sum in another order
      const auto force = forces(solid);
      const double scale = largest(force);
      for (const std::size_t i : {std::size_t{0}, std::size_t{37}, sums.x.size() - 1})  // a corner, an inner one, the other corner
        for (std::size_t c = 0; c < 3; ++c) {
          const double h = 1e-8;  // central difference: error h² relative to (strain scale 1e-2)² and rounding 1e-13/1e-5, both below 1e-5
          sums.x[i][c] += h;
          const double above = sums.energy();
          sums.x[i][c] -= 2 * h;
          const double below = sums.energy();
          sums.x[i][c] += h;
          const double gradient = -(above - below) / (2 * h) / solid.particles.volume();
          CHECK(std::fabs(force[3 * i + c] - gradient) <= 1e-5 * scale);
        }
    }
}

TEST_CASE("internal force: a rigid motion, however large its rotation, gives no force") {
  for (const double nu : all_ratios) {
    Body solid = body({.poissons_ratio = nu});
    const double angle = 1.1;
    fixtures::deform(solid, [&](const Vec3d& X) {
      return Vec3d{std::cos(angle) * X.x - std::sin(angle) * X.y + 0.3, std::sin(angle) * X.x + std::cos(angle) * X.y - 0.2, X.z + 0.1};
    });
    solid.internal.evaluate(solid.particles, solid.family);
    // coordinates near 0.4 m are rounded to 5e-17 m, which is a strain of 5e-14 on the spacing; a strained family of 178 bonds
    // pulls with about E/Δ times its strain
    CHECK(largest(forces(solid)) <= 1e-12 * fixtures::youngs_modulus / 0.001);
  }
}

TEST_CASE("internal force: what one particle gains another loses, to rounding") {
  for (const double nu : all_ratios)
    for (const SurfaceCorrection correction : all_corrections) {
      Body solid = body({.poissons_ratio = nu, .correction = correction});
      fixtures::shake(solid, 1e-5);
      solid.internal.evaluate(solid.particles, solid.family);
      const auto force = forces(solid);
      Vec3d sum{};
      for (std::size_t n = 0; n < force.size(); n += 3) sum += Vec3d{force[n], force[n + 1], force[n + 2]};
      // each pair is exactly opposite; what is left is the rounding of 2700 sums of 178 terms: their random walk is below 1e-13 of the whole
      CHECK(largest_magnitude(sum) <= 1e-13 * largest(force) * static_cast<double>(solid.particles.size()));
    }
}

TEST_CASE("internal force: one, two and four threads give the same bits") {
  const int before = fccda::thread_count();
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 4}) {
    fccda::use_threads(threads);
    Body solid = body({.poissons_ratio = 0.3, .critical_stretch = 5e-3});
    fixtures::shake(solid, 3e-6);
    solid.internal.evaluate(solid.particles, solid.family);
    results.push_back(forces(solid));
    CHECK(solid.internal.broken_bonds() > 100);
  }
  fccda::use_threads(before);
  CHECK(results[0] == results[1]);
  CHECK(results[0] == results[2]);
}

TEST_CASE("internal force: a bond breaks at both of its ends, for ever, and no other breaks") {
  for (const double nu : {0.25, 0.3}) {
    const double critical = 5e-3;
    Body solid = body({.poissons_ratio = nu, .critical_stretch = critical});
    fixtures::shake(solid, 3e-6);
    solid.internal.evaluate(solid.particles, solid.family);
    const auto& bonds = solid.family.stencil().bonds();
    std::size_t intact_ends = 0, broken_ends = 0;
    for (const std::uint32_t slot : solid.particles.slot_of()) {
      const auto [i, j, k] = solid.particles.lattice().cell(slot);
      for (std::size_t b = 0; b < bonds.size(); ++b) {
        if (!solid.particles.lattice().contains(i + bonds[b].di, j + bonds[b].dj, k + bonds[b].dk)) continue;
        const std::size_t other = solid.particles.lattice().slot(i + bonds[b].di, j + bonds[b].dj, k + bonds[b].dk);
        const bool intact = solid.family.is_intact(slot, b);
        const std::size_t opposite = bonds.size() - 1 - b;  // the stencil is sorted, so that opposite bonds mirror one another
        CHECK(intact == solid.family.is_intact(other, opposite));
        const double stretch = norm(solid.particles.position.at(other) - solid.particles.position.at(slot)) / bonds[b].length - 1;
        if (std::fabs(stretch - critical) > 1e-12) CHECK(intact == (stretch < critical));
        intact ? ++intact_ends : ++broken_ends;
      }
    }
    CHECK(broken_ends == 2 * solid.internal.broken_bonds());
    CHECK(intact_ends == 2 * solid.family.intact_bonds());
    const std::size_t broken = solid.internal.broken_bonds();
    CHECK(broken > 100);
    fixtures::deform(solid, [](const Vec3d& X) { return X; });  // back in place: what is broken stays broken
    solid.internal.evaluate(solid.particles, solid.family);
    CHECK(solid.internal.broken_bonds() == broken);
    CHECK(solid.family.intact_bonds() + broken == solid.family.initial_bonds());
  }
}

TEST_CASE("internal force: compression breaks no bond, and without a critical stretch none breaks at all") {
  Body squeezed = body({.critical_stretch = 1e-3});
  fixtures::deform(squeezed, [](const Vec3d& X) { return 0.9 * X; });
  squeezed.internal.evaluate(squeezed.particles, squeezed.family);
  CHECK(squeezed.internal.broken_bonds() == 0);
  Body drawn = body();
  fixtures::deform(drawn, [](const Vec3d& X) { return 2.0 * X; });
  drawn.internal.evaluate(drawn.particles, drawn.family);
  CHECK(drawn.family.intact_bonds() == drawn.family.initial_bonds());
}

TEST_CASE("internal force: where the factors of all bonds are 1, the corrected kernel gives the same bits as the plain one") {
  Body corrected = body({.size = {0.034, 0.021, 0.021}}), uncorrected = body({.size = {0.034, 0.021, 0.021}, .correction = SurfaceCorrection::none});
  fixtures::shake(corrected, 1e-6), fixtures::shake(uncorrected, 1e-6);
  corrected.internal.evaluate(corrected.particles, corrected.family);
  uncorrected.internal.evaluate(uncorrected.particles, uncorrected.family);
  const Lattice& lattice = corrected.particles.lattice();
  const std::size_t inner = lattice.slot(9, 10, 10);  // shares its pack with particles at the surface, so that the corrected kernel runs
  CHECK(!corrected.internal.correction().is_plain(inner / 8));
  CHECK(corrected.particles.force_density.at(inner) == uncorrected.particles.force_density.at(inner));
  const std::size_t edge = lattice.slot(0, 10, 10);
  CHECK(corrected.particles.force_density.at(edge) != uncorrected.particles.force_density.at(edge));
}
