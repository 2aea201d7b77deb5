#include "perimpact/body/bending.hpp"

#include <algorithm>
#include <vector>

#include "perimpact/family/family.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state_force.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

namespace {

/// A linear function of the bulges c_k: value + Σ slope_k c_k.
struct Linear {
  double value = 0;
  std::vector<double> slope;

  explicit Linear(std::size_t unknowns) : slope(unknowns, 0.0) {}
  void add(double factor, const Linear& other) {
    value += factor * other.value;
    for (std::size_t k = 0; k < slope.size(); ++k) slope[k] += factor * other.slope[k];
  }
};

/// Weighted sum of squares of such functions, to be minimised.
class Squares {
 public:
  explicit Squares(std::size_t unknowns) : sum_(0), right_(unknowns, 0.0), matrix_(unknowns, std::vector<double>(unknowns, 0.0)) {}

  void add(double weight, const Linear& term) {
    sum_ += weight * term.value * term.value;
    for (std::size_t r = 0; r < right_.size(); ++r) {
      right_[r] -= weight * term.slope[r] * term.value;
      for (std::size_t c = 0; c < right_.size(); ++c) matrix_[r][c] += weight * term.slope[r] * term.slope[c];
    }
  }

  /// Minimum of Σ weight value². The first unknown stays 0: a common shift of all is a rigid translation.
  double least() const {
    std::vector<std::vector<double>> a = matrix_;
    std::vector<double> b = right_;
    double least = sum_;
    for (std::size_t k = 1; k < b.size(); ++k) {       // symmetric elimination (Cholesky); the minimum is sum - bᵀ A⁻¹ b
      if (a[k][k] <= 1e-12 * matrix_[k][k]) continue;  // a layer without bonds across
      for (std::size_t r = k + 1; r < b.size(); ++r) {
        const double factor = a[r][k] / a[k][k];
        for (std::size_t c = k; c < b.size(); ++c) a[r][c] -= factor * a[k][c];
        b[r] -= factor * b[k];
      }
      least -= b[k] * b[k] / a[k][k];
    }
    return least;
  }

 private:
  double sum_;
  std::vector<double> right_;
  std::vector<std::vector<double>> matrix_;
};

}  // namespace

double relative_bending_stiffness(const ThinLattice& plate, const OrdinaryState& law, CorrectionKind correction, const Stencil& stencil) {
  const bool is_plane = plate.thickness.has_value();
  const std::size_t along = is_plane ? 1 - plate.axis : (plate.axis + 1) % 3;
  // influence of the plate's edge: the correction factors within a horizon, one more with each sweep, and the families of the middle column
  const int half = (CorrectionFactors::sweeps + 3) * stencil.reach();
  Lattice lattice{.cells = {2 * half + 1, 2 * half + 1, is_plane ? 1 : 2 * half + 1}, .spacing = plate.spacing, .thickness = plate.thickness};
  lattice.cells[plate.axis] = plate.layers;
  for (std::size_t axis = 0; axis < 3; ++axis) lattice.origin[axis] = -0.5 * (lattice.cells[axis] - 1) * plate.spacing;

  const Particles particles(lattice, stencil.reach(), 1.0, [](const Vec3d&) { return true; });
  const Family family(stencil, particles);
  const CorrectionFactors factors(correction, basis_of(law), family, particles);

  const auto unknowns = static_cast<std::size_t>(plate.layers);
  const auto layer_of = [&](const Vec3d& X) { return static_cast<std::size_t>(std::lround((X[plate.axis] - lattice.origin[plate.axis]) / plate.spacing)); };
  Squares energy(unknowns);  // of the middle column, [J] for κ = 1/m
  std::array<int, 3> cell{half, half, is_plane ? 0 : half};
  for (int layer = 0; layer < plate.layers; ++layer) {
    cell[plate.axis] = layer;
    const std::size_t i = lattice.slot(cell[0], cell[1], cell[2]);
    const Vec3d X = particles.reference(i);
    Linear theta(unknowns);
    family.for_each_bond(i, [&](const FamilyBond& bond) {
      const Vec3d Y = particles.reference(bond.j);
      const double x = Y[along] - X[along], n = bond.direction[plate.axis];
      Linear e(unknowns);  // elongation [m]
      e.value = bond.direction[along] * x * Y[plate.axis] - n * 0.5 * x * x;
      e.slope[layer_of(Y)] += n;
      e.slope[layer_of(X)] -= n;
      const BondWeights weights = law.weights(bond.length);
      const Vec3d interpolation = interpolation_weights(bond.direction);
      const double stretch = weights.stretch / (bond.length * bond.length) * bond.volume * factors.stretch_factor(i, bond.j, interpolation);
      energy.add(law.b() * stretch * particles.volume(i), e);
      theta.add(law.d() * weights.dilatation / bond.length * bond.volume * factors.dilatation_factor(i, bond.j, interpolation), e);
    });
    const double own = correction == CorrectionKind::family ? 2 * factors.own_family().component(0)[i] : 1;
    energy.add(law.a() * own * own * particles.volume(i), theta);
  }
  const IsotropicElastic& elastic = law.elastic();
  const double h = plate.layers * plate.spacing, nu = elastic.poissons_ratio;
  const double classical = elastic.youngs_modulus / (is_plane ? 1 : 1 - nu * nu) * h * h * h / 12;  // [N m]
  const double area = plate.spacing * plate.thickness.value_or(plate.spacing);
  return 2 * energy.least() / area / classical;
}

}  // namespace perimpact
