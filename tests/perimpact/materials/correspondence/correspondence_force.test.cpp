#include "perimpact/materials/correspondence/correspondence_force.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"

using namespace perimpact;
using fccda::Mat3;
using fixtures::body;
using fixtures::BodyOptions;
using fixtures::Model;

namespace {

/// Correspondence in 3-D and 2-D, on lattices and clouds, with both laws.
std::vector<fixtures::NamedOptions> every_correspondence(const Vec3d& size) {
  std::vector<fixtures::NamedOptions> all;
  for (fixtures::NamedOptions& one : fixtures::every_body(size))
    if (one.options.model == Model::correspondence) all.push_back(std::move(one));
  return all;
}

BodyOptions correspondence(const Vec3d& size = {0.010, 0.007, 0.006}) { return {.size = size, .poissons_ratio = 0.3, .model = Model::correspondence}; }

double total_volume(const Body& body) { return body.particles.total_mass() / body.particles.density(); }

double largest_force(const Body& body) {
  double largest = 0;
  for (const std::uint32_t slot : body.particles.slot_of())
    largest = fixtures::larger(largest, fccda::largest_magnitude(body.particles.force_density.at(slot)));
  return largest;
}

std::vector<Vec3d> forces(Body& body) {
  body.internal.evaluate(body.particles, body.family);
  std::vector<Vec3d> all;
  for (const std::uint32_t slot : body.particles.slot_of()) all.push_back(body.particles.force_density.at(slot));
  return all;
}

/// All bond flags, as stored in a checkpoint.
std::vector<std::uint8_t> bonds_of(Body& body) {
  std::vector<std::uint8_t> bits;
  body.family.visit_state("", [&](const std::string&, std::span<std::uint8_t> values) { bits.assign(values.begin(), values.end()); });
  return bits;
}
void put_bonds(Body& body, const std::vector<std::uint8_t>& bits) {
  body.family.visit_state("", [&](const std::string&, std::span<std::uint8_t> values) { std::copy(bits.begin(), bits.end(), values.begin()); });
}

void cut_at_random(Body& body, double share) {
  body.family.cut([share](std::size_t i, std::size_t j) { return fixtures::drawn(i, j) < share; });
}

/// Compares forces with central differences of the reported energy, at some particles.
void check_gradient(Body& solid, double h, double tolerance) {
  const auto force = forces(solid);
  const double scale = largest_force(solid);
  const auto slots = solid.particles.slot_of();
  for (std::size_t n = 0; n < slots.size(); n += slots.size() / 5)
    for (std::size_t c = 0; c < (solid.particles.is_plane() ? 2 : 3); ++c) {
      double& x = solid.particles.position.component(c)[slots[n]];
      const double here = x;
      x = here + h;
      const double above = solid.internal.evaluate_with_energy(solid.particles, solid.family);
      x = here - h;
      const double below = solid.internal.evaluate_with_energy(solid.particles, solid.family);
      x = here;
      CHECK(std::fabs(force[n][c] + (above - below) / (2 * h) / solid.particles.volume(slots[n])) <= tolerance * scale);
    }
}

/// Stiffness of a bar of 4 × 4 particles in bending or torsion, over that of Saint-Venant's theory. Three layers at each end are displaced according
/// to the theory, the others are brought to equilibrium by conjugate gradients; the moment at one end is compared with the curvature, or twist, at the middle.
double stiffness_of_bar(Stabilisation stabilisation, bool torsion) {
  BodyOptions options = correspondence({0.032, 0.004, 0.004});
  options.stabilisation = stabilisation;
  Body bar = body(options);
  const double nu = options.poissons_ratio, side = 0.004, E = fixtures::youngs_modulus;
  const std::vector<std::uint32_t> slots(bar.particles.slot_of().begin(), bar.particles.slot_of().end());
  const std::size_t n = slots.size();
  using Field = std::vector<Vec3d>;
  Field X(n), u(n), residual(n);
  for (std::size_t i = 0; i < n; ++i) X[i] = bar.particles.reference(slots[i]);
  const auto is_held = [&](std::size_t i) { return std::fabs(X[i].x) > 0.013; };
  const auto inner = [&](const Field& a, const Field& b) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += dot(a[i], b[i]);
    return sum;
  };
  const auto force_of = [&](const Field& v) {
    double largest = 0;
    for (const Vec3d& one : v) largest = fixtures::larger(largest, fccda::largest_magnitude(one));
    const double scale = 1e-6 * bar.particles.spacing() / largest;  // linear to as much
    for (std::size_t i = 0; i < n; ++i) bar.particles.position.set(slots[i], X[i] + scale * v[i]);
    Field f = forces(bar);
    for (Vec3d& one : f) one *= 1 / scale;
    return f;
  };
  const auto of_free = [&](Field f) {
    for (std::size_t i = 0; i < n; ++i)
      if (is_held(i)) f[i] = {};
    return f;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const auto [x, y, z] = X[i];
    u[i] = torsion ? Vec3d{0, -x * z, x * y} : Vec3d{x * z, -nu * y * z, -0.5 * (x * x + nu * (z * z - y * y))};
  }
  const Field first = force_of(u);
  residual = of_free(first);
  Field direction = residual;
  double square = inner(residual, residual);
  for (int iteration = 0; iteration < 60 && square > 1e-12 * inner(first, first); ++iteration) {
    const Field image = of_free(force_of(direction));
    const double step = -square / inner(direction, image);
    for (std::size_t i = 0; i < n; ++i) u[i] += step * direction[i], residual[i] += step * image[i];
    const double next = inner(residual, residual);
    for (std::size_t i = 0; i < n; ++i) direction[i] = residual[i] + (next / square) * direction[i];
    square = next;
  }
  const Field f = force_of(u);
  double moment = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (is_held(i) && X[i].x > 0) moment -= (torsion ? X[i].y * f[i].z - X[i].z * f[i].y : X[i].z * f[i].x - X[i].x * f[i].z) * bar.particles.volume(slots[i]);
  const auto turn_at = [&](double x) {
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (std::fabs(X[i].x - x) > 1e-4) continue;
      sum += torsion ? u[i].z * X[i].y - u[i].y * X[i].z : u[i].x * X[i].z;
      weights += torsion ? X[i].y * X[i].y + X[i].z * X[i].z : X[i].z * X[i].z;
    }
    return sum / weights;
  };
  const double turn = (turn_at(0.0045) - turn_at(-0.0045)) / 0.009;
  // of a square section: a⁴/12, and 0.1406 a⁴ (Timoshenko and Goodier, Theory of Elasticity, art. 109)
  return moment / turn / (torsion ? E / (2 * (1 + nu)) * 0.1406 * std::pow(side, 4) : E * std::pow(side, 4) / 12);
}

}  // namespace

TEST_CASE("correspondence: a bar of four layers bends and twists as Saint-Venant's, which one-sided gradients do not permit") {
  // the error is of the order (δ/H)², with δ/H = 3/4: -10 % and +8 %
  CHECK(stiffness_of_bar(Stabilisation::bond_level, false) == fixtures::relative(1, 0.11));
  CHECK(stiffness_of_bar(Stabilisation::bond_level, true) == fixtures::relative(1, 0.11));
  CHECK(stiffness_of_bar(Stabilisation::wan, false) > 4);
  CHECK(stiffness_of_bar(Stabilisation::wan, true) > 5);
}

TEST_CASE("correspondence: uniform strain of any size has exactly the energy of the classical law, on lattices and clouds") {
  const Mat3 dilated = Mat3::diagonal({1.1, 1.1, 1.1}), drawn = Mat3::diagonal({1.2, 0.95, 1.0}), sheared{{{1, 0.3, 0}, {0, 1, 0}, {0, 0, 1}}},
             turned{{{0, -1.05, 0}, {1, 0, 0}, {0, 0, 1}}};
  for (const fixtures::NamedOptions& one : every_correspondence({0.006, 0.005, 0.004})) {
    const BodyOptions& options = one.options;
    CAPTURE(one.name);
    Body solid = body(options);
    for (Mat3 F : {dilated, drawn, sheared, turned}) {
      const bool plane = solid.particles.is_plane();
      if (plane) F.row[2].z = 1;
      fixtures::deform(solid, [&](const Vec3d& X) { return F * X; });
      const Mat3 C = transpose(F) * F;
      const IsotropicElastic& elastic = solid.internal.correspondence()->elastic();
      // block diagonal: a symmetric 2 × 2 matrix and a third eigenvalue
      const double mean = 0.5 * (C.row[0].x + C.row[1].y), radius = std::hypot(0.5 * (C.row[0].x - C.row[1].y), C.row[0].y);
      double volume = 0, squares = 0;
      for (const double c : {mean + radius, mean - radius, C.row[2].z}) {
        const double strain = options.law == StressLaw::hencky ? 0.5 * std::log(c) : 0.5 * (c - 1);
        volume += strain, squares += strain * strain;
      }
      const double density = 0.5 * elastic.lame_modulus() * volume * volume + elastic.shear_modulus() * squares;
      // gradients are sums of a hundred terms, accurate to about 1e-15, with strains of 0.05 and more
      CHECK(solid.internal.evaluate_with_energy(solid.particles, solid.family) == fixtures::relative(density * total_volume(solid), 1e-12));
    }
  }
}

TEST_CASE("correspondence: under uniform strain no force acts on interior particles of a lattice") {
  for (const Plane plane : {Plane::none, Plane::stress})
    for (const StressLaw law : {StressLaw::hencky, StressLaw::st_venant_kirchhoff}) {
      BodyOptions options = correspondence(plane == Plane::none ? Vec3d{0.021, 0.021, 0.021} : Vec3d{0.023, 0.022, 0.001});
      options.plane = plane, options.law = law;
      Body solid = body(options);
      fixtures::deform(solid, [](const Vec3d& X) { return Vec3d{1.02 * X.x + 0.03 * X.y, 0.99 * X.y, X.z}; });
      solid.internal.evaluate(solid.particles, solid.family);
      const Lattice& lattice = *solid.particles.lattice();
      const std::size_t middle =
          lattice.slot(10, 10, plane == Plane::none ? 10 : 0);  // three horizons from the surface: families of its neighbours' neighbours are complete
      // at the surface the stress of 0.03 E ends within a spacing; inside it is rounding of that
      CHECK(largest_force(solid) > 1e-3 * fixtures::youngs_modulus / options.spacing);
      CHECK(fccda::largest_magnitude(solid.particles.force_density.at(middle)) < 1e-14 * fixtures::youngs_modulus / options.spacing);
    }
}

TEST_CASE("correspondence: a checkerboard has no strain, and only the stabilisation resists it") {
  for (const Stabilisation stabilisation : {Stabilisation::bond_level, Stabilisation::wan, Stabilisation::silling}) {
    const auto force_of_middle = [&](double factor) {
      BodySetup setup = fixtures::body_setup(correspondence({0.027, 0.027, 0.027}));
      std::get<CorrespondenceSetup>(setup.material).stabilisation_factor = factor;
      std::get<CorrespondenceSetup>(setup.material).stabilisation.index = static_cast<int>(stabilisation);
      Body solid = make_body(setup);
      const Lattice& lattice = *solid.particles.lattice();
      for (const std::uint32_t slot : solid.particles.slot_of()) {
        const auto [i, j, k] = lattice.cell(slot);
        solid.particles.position.set(slot, solid.particles.reference(slot) + Vec3d{(i + j + k) % 2 ? 1e-6 : -1e-6, 0, 0});
      }
      solid.internal.evaluate(solid.particles, solid.family);
      return solid.particles.force_density.at(lattice.slot(13, 13, 13)).x;  // four horizons from the surface, where gradients are not zero
    };
    // 1e-6 m on bonds of 3e-3 m and a modulus of 2e11 Pa
    const double whole = force_of_middle(1), none = force_of_middle(1e-12);
    CHECK(whole < -1e10);  // pulls it back: the middle, where i + j + k is odd, is displaced by +
    CHECK(std::fabs(none) < 1e-9 * std::fabs(whole));
  }
}

TEST_CASE("correspondence: Wan's constant equals his tensor in a complete family, and Silling's is 18κ/(πδ⁵)/2 for constant influence") {
  BodyOptions options = correspondence({0.015, 0.009, 0.009});
  options.stabilisation = Stabilisation::wan;
  Body solid = body(options);
  const Correspondence& law = *solid.internal.correspondence();
  const double lambda = law.elastic().lame_modulus(), mu = law.elastic().shear_modulus(), kappa = law.elastic().bulk_modulus();
  const CorrespondenceForce<3> force(law, {}, solid.family, solid.particles);
  const auto inverse = force.inverse_shape(solid.particles.lattice()->slot(7, 4, 4));
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t s = 0; s < 3; ++s)
      CHECK(2 * mu * inverse.m[r][s] + (r == s ? lambda * trace(inverse) : 0) ==
            fixtures::absolute(r == s ? law.stabilisation(trace(inverse)) : 0, 1e-12 * kappa * trace(inverse), "N/m7"));
  const double delta = 0.003;
  const Correspondence silling({1.0, 0.3, 3}, {.stabilisation = Stabilisation::silling, .influence = Influence::constant}, delta, 1);
  CHECK(silling.stabilisation(1e20) == fixtures::relative(9 * silling.elastic().bulk_modulus() / (3.14159265358979 * std::pow(delta, 5)), 1e-12));
  CHECK(law.stabilisation(trace(inverse)) == fixtures::relative(kappa * trace(inverse), 1e-12));
}

TEST_CASE("correspondence: forces depend on the current bonds alone, whatever cut or restored them") {
  for (const fixtures::NamedOptions& one : every_correspondence({0.006, 0.005, 0.004})) {
    const BodyOptions& options = one.options;
    CAPTURE(one.name);
    Body solid = body(options);
    const auto whole = bonds_of(solid);
    fixtures::shake(solid, 1e-5);
    const auto at_first = forces(solid);
    cut_at_random(solid, 0.3);
    const auto cut = forces(solid);
    CHECK(cut != at_first);
    Body resumed = body(options);  // as on restart: a new body gets the stored bonds
    fixtures::shake(resumed, 1e-5);
    put_bonds(resumed, bonds_of(solid));
    CHECK(forces(resumed) == cut);
    put_bonds(solid, whole);
    CHECK(forces(solid) == at_first);
  }
}

TEST_CASE("correspondence: with nine tenths of its bonds broken, the force of a body is still the gradient of its energy") {
  for (const fixtures::NamedOptions& one : every_correspondence({0.006, 0.005, 0.004})) {
    const BodyOptions& options = one.options;
    CAPTURE(one.name);
    Body solid = body(options);
    cut_at_random(solid, 0.9);
    fixtures::shake(solid, 1e-5);
    check_gradient(solid, 1e-8, 1e-5);  // as in the test of complete families
  }
}

TEST_CASE("correspondence: flattened or inverted families have finite forces, still the gradient of the energy") {
  for (const StressLaw law : {StressLaw::hencky, StressLaw::st_venant_kirchhoff})
    for (const double z : {0.05, 0.0, -0.4}) {
      CAPTURE(z);
      BodyOptions options = correspondence({0.006, 0.005, 0.004});
      options.law = law;
      Body solid = body(options);
      fixtures::deform(solid, [&](const Vec3d& X) { return Vec3d{1.1 * X.x, 0.9 * X.y, z * X.z}; });
      fixtures::shake(solid, 1e-5);
      CHECK(largest_force(solid) < 1e6 * fixtures::youngs_modulus);
      check_gradient(solid, 1e-8, 1e-4);  // the second derivative jumps at the transition to the tangent
    }
}

TEST_CASE("correspondence: particles whose bonds span no volume have no stress, four whose bonds do have one") {
  const double h = 0.001;
  const auto force_of = [&](const std::vector<Vec3d>& points, std::optional<double> thickness = {}) {
    Cloud cloud{.points = points, .volumes = std::vector<double>(points.size(), h * h * thickness.value_or(h)), .thickness = thickness};
    Particles particles(cloud, fixtures::density);
    Family family(find_bonds(FamilyRule::hu_ha_bobaru, 3 * h, particles), particles);
    const IsotropicElastic elastic = IsotropicElastic::in(thickness ? Plane::stress : Plane::none, fixtures::youngs_modulus, 0.3);
    const Correspondence law(elastic, {}, 3 * h, thickness.value_or(1));
    const auto make = [&]() -> InternalForce::Kind {
      if (thickness) return CorrespondenceForce<2>(law, {}, family, particles);
      return CorrespondenceForce<3>(law, {}, family, particles);
    };
    InternalForce internal(make(), particles);
    Body loose{"body", std::move(particles), std::move(family), std::move(internal)};
    fixtures::deform(loose, [](const Vec3d& X) { return Vec3d{1.01 * X.x, 1.02 * X.y, 1.03 * X.z}; });
    loose.internal.evaluate(loose.particles, loose.family);
    return largest_force(loose);
  };
  CHECK(force_of({{0, 0, 0}}) == 0);
  CHECK(force_of({{0, 0, 0}, {h, 0, 0}}) == 0);
  CHECK(force_of({{0, 0, 0}, {h, 0, 0}, {0, h, 0}}) == 0);
  CHECK(force_of({{0, 0, 0}, {h, 0, 0}, {0, h, 0}, {h, 1.3 * h, 0}, {-h, 0.7 * h, 0}}) == 0);  // all in one plane, at irregular positions
  CHECK(force_of({{0, 0, 0}, {h, 0, 0}, {0, h, 0}, {0, 0, h}}) > 1e-3 * fixtures::youngs_modulus / h);
  CHECK(force_of({{0, 0, 0}, {h, 0, 0}, {2 * h, 0, 0}}, h) == 0);
  CHECK(force_of({{0, 0, 0}, {h, 0, 0}, {0, h, 0}}, h) > 1e-3 * fixtures::youngs_modulus / h);
}

TEST_CASE("correspondence: a body one particle thick is rejected unless it is 2-D") {
  BodyOptions sheet = correspondence({0.010, 0.007, 0.001});
  try {
    body(sheet);
    CHECK_MESSAGE(false, "no exception was thrown");
  } catch (const std::exception& error) {
    CHECK(std::string(error.what()).find("its particles have neighbours in one plane only") != std::string::npos);
  }
  sheet.plane = Plane::stress;
  CHECK(body(sheet).particles.size() == 70);
}
