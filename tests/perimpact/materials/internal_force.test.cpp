#include "perimpact/materials/internal_force.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/parallel.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/small_matrices.hpp"

using namespace perimpact;
using fccda::Mat3;
using fixtures::body;
using fixtures::BodyOptions;

namespace {

/// Reference for the elastic energy: a loop over all pairs of particles, which shares only the constants of the law and the factors of particles
/// with the kernels.
struct PairSums {
  const Body& body;
  std::vector<std::size_t> slots;
  std::vector<Vec3d> X, x;

  explicit PairSums(const Body& of) : body(of), slots(of.particles.slot_of().begin(), of.particles.slot_of().end()) {
    for (const std::size_t slot : slots) X.push_back(body.particles.reference(slot)), x.push_back(body.particles.position.at(slot));
  }
  double factor(std::size_t i, std::size_t j, const Vec3d& xi, bool stretch) const {
    const CorrectionFactors& correction = body.internal.ordinary_state()->correction();
    const auto both = [&](const ScalarArray& array) { return array.component(0)[slots[i]] + array.component(0)[slots[j]]; };
    switch (correction.kind()) {
      case CorrectionKind::none:
        return 1;
      case CorrectionKind::volume:
        return 1 / both(correction.volume());
      case CorrectionKind::family:
        return stretch ? both(correction.own_family()) : 1;
      case CorrectionKind::energy:
        break;
    }
    const VectorArray& g = stretch ? correction.stretch() : correction.dilatation();
    double sum = 0;
    for (std::size_t p = 0; p < 3; ++p) sum += xi[p] * xi[p] / squared_norm(xi) * 0.5 * (g.at(slots[i])[p] + g.at(slots[j])[p]);
    return sum;
  }
  double energy() const { return body.internal.correspondence() ? correspondence_energy() : ordinary_energy(); }

  /// Calls visit(j, ξ, v V) for all bonds of particle i.
  template <class Visit>
  void for_each_neighbour(std::size_t i, const Visit& visit) const {
    const double delta = body.family.horizon();
    for (std::size_t j = 0; j < X.size(); ++j) {
      const Vec3d xi = X[j] - X[i];
      const double length = norm(xi), size = 0.5 * (body.particles.size_of(slots[i]) + body.particles.size_of(slots[j]));
      if (j == i || length >= delta + size / 2 * (1 - 1e-9)) continue;
      visit(j, xi, std::min(1.0, (delta + size / 2 - length) / size) * body.particles.volume(slots[j]));
    }
  }

  /// K⁻¹ and F of each particle, with χ = 1 (in 2-D, z is inactive).
  struct Gradients {
    std::vector<Mat3> inverse, F;
  };
  Gradients gradients() const {
    const Correspondence& law = *body.internal.correspondence();
    Gradients all;
    for (std::size_t i = 0; i < X.size(); ++i) {
      Mat3 K{}, M{};
      for_each_neighbour(i, [&](std::size_t j, const Vec3d& xi, double volume) {
        add_outer(K, xi, xi, law.weight(norm(xi)) * volume), add_outer(M, x[j] - x[i], xi, law.weight(norm(xi)) * volume);
      });
      if (body.particles.is_plane()) K.row[2].z = M.row[2].z = 1;
      all.inverse.push_back(fixtures::inverse_of(K)), all.F.push_back(M * all.inverse.back());
    }
    return all;
  }
  static void add_outer(Mat3& sum, const Vec3d& a, const Vec3d& b, double weight) {
    for (std::size_t r = 0; r < 3; ++r) sum.row[r] += (weight * a[r]) * b;
  }

  /// ψ(F) + c/2 Σ ω |z|² v V, with the classical laws in the principal stretches, and Wan's c by the tensor C1 itself; for the stabilisation bond-level
  /// F + Σ ω (y - F̄ξ)⊗ξ v V K⁻¹ in place of F, and y - F̄ξ in place of z.
  double correspondence_energy() const {
    const Correspondence& law = *body.internal.correspondence();
    const double kappa = law.elastic().bulk_modulus(), mu = law.elastic().shear_modulus();
    const bool plane = body.particles.is_plane(), bond_level = law.options().stabilisation == Stabilisation::bond_level;
    const int dimension = plane ? 2 : 3;
    const double lambda = kappa - 2 * mu / dimension, delta = body.family.horizon(), thickness = plane ? body.particles.thickness().value() : 1;
    const double m = weighted_volume(law.options().influence, delta, dimension, thickness);
    const Gradients all = gradients();
    double total = 0;
    for (std::size_t i = 0; i < X.size(); ++i) {
      Mat3 F = all.F[i], residuals{};
      double left = 0;
      for_each_neighbour(i, [&](std::size_t j, const Vec3d& xi, double v) {
        const Vec3d own = x[j] - x[i] - all.F[i] * xi, z = bond_level ? 0.5 * (own + (x[j] - x[i] - all.F[j] * xi)) : own;
        left += law.weight(norm(xi)) * squared_norm(z) * v;
        add_outer(residuals, z, xi, law.weight(norm(xi)) * v);
      });
      if (bond_level)
        for (std::size_t r = 0; r < 3; ++r) F.row[r] += (residuals * all.inverse[i]).row[r];
      double volume_strain = 0, squares = 0;
      for (const double c : fixtures::eigenvalues_of(transpose(F) * F)) {
        const double strain = law.options().law == StressLaw::hencky ? 0.5 * std::log(c) : 0.5 * (c - 1);
        volume_strain += strain, squares += strain * strain;
      }
      const double inverse_trace = all.inverse[i].row[0].x + all.inverse[i].row[1].y + (plane ? 0 : all.inverse[i].row[2].z);
      const double m1_over_m = weighted_volume(Influence::constant, delta, dimension, thickness) / m;
      const double silling = 0.5 * m1_over_m * kappa / std::numbers::pi * (plane ? 12 / (thickness * std::pow(delta, 4)) : 18 / std::pow(delta, 5));
      const double c = bond_level ? 2 * dimension * mu / m : law.options().stabilisation == Stabilisation::wan ? kappa * inverse_trace : silling;
      total += (0.5 * lambda * volume_strain * volume_strain + mu * squares + 0.5 * c * left) * body.particles.volume(slots[i]);
    }
    return total;
  }

  double ordinary_energy() const {
    const OrdinaryStateForce& force = *body.internal.ordinary_state();
    const OrdinaryState& m = force.law();
    double total = 0;
    for (std::size_t i = 0; i < X.size(); ++i) {
      const double own = force.correction().kind() == CorrectionKind::family ? 2 * force.correction().own_family().component(0)[slots[i]] : 1;
      double theta = 0, bonds = 0;
      for_each_neighbour(i, [&](std::size_t j, const Vec3d& xi, double v) {
        const double length = norm(xi), e = norm(x[j] - x[i]) - length;
        theta += own * m.d() * m.weights(length).dilatation / length * e * v * factor(i, j, xi, false);
        bonds += m.b() * m.weights(length).stretch / (length * length) * e * e * v * factor(i, j, xi, true);
      });
      total += (m.a() * theta * theta + bonds) * body.particles.volume(slots[i]);
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

}  // namespace

TEST_CASE("internal force: the SIMD and the scalar kernel agree for every material, dimension and kind of points") {
  for (const fixtures::NamedOptions& one : fixtures::every_body()) {
    const BodyOptions& options = one.options;
    CAPTURE(one.name);
    Body wide = body(options), scalar = body(options);
    fixtures::shake(wide, 1e-6), fixtures::shake(scalar, 1e-6);
    wide.internal.evaluate(wide.particles, wide.family);
    scalar.internal.evaluate_scalar(scalar.particles, scalar.family);
    const auto a = forces(wide), b = forces(scalar);
    // rounding of lengths differs by a few 1e-16; at a strain of 1e-3 this is 1e-12 of a bond's force, and less of a family's
    const double tolerance = 1e-12 * largest(b);
    double worst = 0;
    for (std::size_t n = 0; n < a.size(); ++n) worst = fixtures::larger(worst, std::fabs(a[n] - b[n]));
    CHECK(worst <= tolerance);
    CHECK(largest(b) > 0);
  }
}

TEST_CASE("internal force: it is the gradient of the energy from a loop over all pairs, for every material, dimension and kind of points") {
  for (const fixtures::NamedOptions& one : fixtures::every_body({0.006, 0.005, 0.004})) {
    const BodyOptions& options = one.options;
    CAPTURE(one.name);
    Body solid = body(options);
    fixtures::shake(solid, 1e-5);
    const double reported = solid.internal.evaluate_with_energy(solid.particles, solid.family);
    PairSums sums(solid);
    CHECK(reported == fixtures::relative(sums.energy(), 1e-11));  // the same sum in another order
    const auto force = forces(solid);
    const double scale = largest(force);
    const std::size_t axes = solid.particles.is_plane() ? 2 : 3;
    for (const std::size_t i : {std::size_t{0}, sums.x.size() / 3, sums.x.size() - 1})  // a corner, an interior particle, the opposite corner
      for (std::size_t c = 0; c < axes; ++c) {
        const double h = 1e-8;  // central difference: error h² relative to (strain scale 1e-2)² and rounding 1e-13/1e-5, both below 1e-5
        sums.x[i][c] += h;
        const double above = sums.energy();
        sums.x[i][c] -= 2 * h;
        const double below = sums.energy();
        sums.x[i][c] += h;
        const double gradient = -(above - below) / (2 * h) / solid.particles.volume(sums.slots[i]);
        CHECK(std::fabs(force[3 * i + c] - gradient) <= 1e-5 * scale);
      }
  }
}

TEST_CASE("internal force: a rigid motion with any rotation gives no force") {
  for (const fixtures::NamedOptions& one : fixtures::every_body()) {
    const BodyOptions& options = one.options;
    CAPTURE(one.name);
    Body solid = body(options);
    const double angle = 1.1;
    fixtures::deform(solid, [&](const Vec3d& X) {
      return Vec3d{std::cos(angle) * X.x - std::sin(angle) * X.y + 0.3, std::sin(angle) * X.x + std::cos(angle) * X.y - 0.2, X.z + 0.1};
    });
    solid.internal.evaluate(solid.particles, solid.family);
    // coordinates near 0.4 m are rounded to 5e-17 m, a strain of 5e-14 on the spacing; the force density of a strained family is about E/Δ times
    // its strain, and with ν = 0.4 and inverse-square influence three times that
    CHECK(largest(forces(solid)) <= 3e-12 * fixtures::youngs_modulus / 0.001);
  }
}

TEST_CASE("internal force: forces and moments sum to zero, to rounding") {
  for (const fixtures::NamedOptions& one : fixtures::every_body()) {
    const BodyOptions& options = one.options;
    CAPTURE(one.name);
    Body solid = body(options);
    fixtures::shake(solid, 1e-5);
    solid.internal.evaluate(solid.particles, solid.family);
    Vec3d sum{}, moment{};
    double scale = 0;
    for (const std::uint32_t slot : solid.particles.slot_of()) {
      const Vec3d force = solid.particles.volume(slot) * solid.particles.force_density.at(slot);
      sum += force;
      moment += cross(solid.particles.position.at(slot), force);
      scale += norm(force);
    }
    // forces of a pair are exactly opposite and along its bond; the rest is rounding of sums of up to 178 terms, each below 1e-15 of the sum
    CHECK(norm(sum) <= 1e-14 * scale);
    CHECK(norm(moment) <= 1e-14 * scale * 0.012);
  }
}

TEST_CASE("internal force: a 2-D body has no out-of-plane force") {
  for (const fixtures::NamedOptions& one : fixtures::every_body()) {
    const BodyOptions& options = one.options;
    if (options.plane == Plane::none) continue;
    Body solid = body(options);
    fixtures::shake(solid, 1e-5);
    solid.internal.evaluate(solid.particles, solid.family);
    for (const std::uint32_t slot : solid.particles.slot_of()) CHECK(solid.particles.force_density.component(2)[slot] == 0);
  }
}

TEST_CASE("internal force: on the points of a lattice the stencil and the neighbour lists give the same forces, to rounding") {
  for (const fixtures::NamedOptions& one : fixtures::every_body()) {
    const BodyOptions& options = one.options;
    if (options.points != fixtures::Points::lattice) continue;
    CAPTURE(one.name);
    BodyOptions with_lists = options;
    with_lists.points = fixtures::Points::listed;
    Body lattice = body(options), listed = body(with_lists);
    fixtures::shake(lattice, 1e-5), fixtures::shake(listed, 1e-5);
    lattice.internal.evaluate(lattice.particles, lattice.family);
    listed.internal.evaluate(listed.particles, listed.family);
    CHECK(lattice.family.initial_bonds() == listed.family.initial_bonds());
    const auto a = forces(lattice), b = forces(listed);
    double worst = 0;
    for (std::size_t n = 0; n < a.size(); ++n) worst = fixtures::larger(worst, std::fabs(a[n] - b[n]));
    // lengths of the list come from coordinates, with an error of 1e-17 m on extensions of 1e-5 m: 1e-12 of the force, for 178 random terms
    CHECK(worst <= 1e-10 * largest(b));
  }
}

TEST_CASE("internal force: factors from a table in the middle of long rows equal those that the neighbour lists compute bond by bond") {
  for (const SurfaceCorrection correction : {SurfaceCorrection::energy, SurfaceCorrection::volume})
    for (const double nu : {0.25, 0.3}) {
      CAPTURE(nu);
      BodyOptions options{.size = {0.056, 0.044, 0.004}, .poissons_ratio = nu, .correction = correction};
      Body lattice = body(options);
      options.points = fixtures::Points::listed;
      Body listed = body(options);
      const CorrectionFactors& factors = lattice.internal.ordinary_state()->correction();
      CHECK(factors.table_of(lattice.particles.lattice()->slot(28, 22, 2) / 8) > 0);
      CHECK(factors.table_of(lattice.particles.lattice()->slot(0, 22, 2) / 8) == CorrectionFactors::no_table);
      fixtures::shake(lattice, 1e-5), fixtures::shake(listed, 1e-5);
      // the same sums, with lengths from coordinates in one and from cells in the other: as above
      CHECK(lattice.internal.evaluate_with_energy(lattice.particles, lattice.family) ==
            fixtures::relative(listed.internal.evaluate_with_energy(listed.particles, listed.family), 1e-10));
      const auto a = forces(lattice), b = forces(listed);
      double worst = 0;
      for (std::size_t n = 0; n < a.size(); ++n) worst = fixtures::larger(worst, std::fabs(a[n] - b[n]));
      CHECK(worst <= 1e-10 * largest(b));
    }
}

TEST_CASE("internal force: results are bitwise identical for one, two and four threads") {
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 4}) {
    const fixtures::Threads with_several(threads);
    std::vector<double> all;
    for (fixtures::NamedOptions one : fixtures::every_body()) {
      BodyOptions& options = one.options;
      options.critical_stretch = 5e-3;
      Body solid = body(options);
      fixtures::shake(solid, 3e-6);
      solid.internal.evaluate(solid.particles, solid.family);
      const auto force = forces(solid);
      all.insert(all.end(), force.begin(), force.end());
    }
    results.push_back(std::move(all));
  }
  CHECK(results[0] == results[1]);
  CHECK(results[0] == results[2]);
}

TEST_CASE("internal force: bond failure is irreversible, acts at both ends, and affects no other bond") {
  for (fixtures::NamedOptions one : fixtures::every_body()) {
    BodyOptions& options = one.options;
    CAPTURE(one.name);
    const double critical = 5e-3;
    options.critical_stretch = critical;
    Body solid = body(options);
    const auto bonds_of = [&](std::size_t slot) {
      std::vector<FamilyBond> bonds;
      solid.family.for_each_bond(slot, [&](const FamilyBond& bond) { bonds.push_back(bond); });
      return bonds;
    };
    const auto all_bonds = [&] {
      std::vector<std::vector<FamilyBond>> all(solid.particles.slots());
      for (const std::uint32_t slot : solid.particles.slot_of()) all[slot] = bonds_of(slot);
      return all;
    };
    const auto initial = all_bonds();
    fixtures::shake(solid, 5e-6);
    solid.internal.evaluate(solid.particles, solid.family);
    const auto now = all_bonds();
    std::size_t intact_ends = 0, broken_ends = 0, wrong = 0, one_sided = 0;
    for (const std::uint32_t slot : solid.particles.slot_of())
      for (const FamilyBond& bond : initial[slot]) {
        const auto has = [&](std::size_t of, std::size_t other) {
          return std::any_of(now[of].begin(), now[of].end(), [&](const FamilyBond& it) { return it.j == other; });
        };
        const bool intact = has(slot, bond.j);
        one_sided += intact != has(bond.j, slot);
        const double stretch = norm(solid.particles.position.at(bond.j) - solid.particles.position.at(slot)) / bond.length - 1;
        wrong += std::fabs(stretch - critical) > 1e-12 && intact != (stretch < critical);
        intact ? ++intact_ends : ++broken_ends;
      }
    CHECK(one_sided == 0);
    CHECK(wrong == 0);
    CHECK(broken_ends == 2 * solid.internal.broken_bonds());
    CHECK(intact_ends == 2 * solid.family.intact_bonds());
    const std::size_t broken = solid.internal.broken_bonds();
    CHECK(broken > 10);
    fixtures::deform(solid, [](const Vec3d& X) { return X; });  // back to the reference positions: broken bonds stay broken
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

TEST_CASE("internal force: where the factors of all bonds are 1, the corrected kernel is bitwise identical to the plain one") {
  Body corrected = body({.size = {0.034, 0.021, 0.021}}), uncorrected = body({.size = {0.034, 0.021, 0.021}, .correction = SurfaceCorrection::none});
  fixtures::shake(corrected, 1e-6), fixtures::shake(uncorrected, 1e-6);
  corrected.internal.evaluate(corrected.particles, corrected.family);
  uncorrected.internal.evaluate(uncorrected.particles, uncorrected.family);
  const Lattice& lattice = *corrected.particles.lattice();
  const std::size_t inner = lattice.slot(9, 10, 10);  // shares its pack with particles at the surface, so that the corrected kernel runs
  CHECK(corrected.internal.ordinary_state()->correction().table_of(inner / 8) != 0);
  CHECK(corrected.particles.force_density.at(inner) == uncorrected.particles.force_density.at(inner));
  const std::size_t edge = lattice.slot(0, 10, 10);
  CHECK(corrected.particles.force_density.at(edge) != uncorrected.particles.force_density.at(edge));
}
