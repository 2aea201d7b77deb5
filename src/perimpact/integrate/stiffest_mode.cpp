#include "perimpact/integrate/stiffest_mode.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "perimpact/damage/strength.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

namespace {

/// Displacements of all particles, in the order of slot_of.
using Displacements = std::vector<Vec3d>;

/// -f/ρ for a displacement of the body: its stiffness over its mass, symmetric in the inner product Σ ρ V a·b.
class Stiffness {
 public:
  Stiffness(const Body& body, std::vector<double> densities) : body_(body), densities_(std::move(densities)) {}

  std::size_t size() const { return body_.particles.size(); }
  double inner(const Displacements& a, const Displacements& b) const {
    return exact_sum_over_eights(body_.particles.share().ranks(), body_.particles.slot_of(),
                                 [&](std::size_t n) { return densities_[slot(n)] * body_.particles.volume(slot(n)) * dot(a[n], b[n]); });
  }

  Displacements times(const Displacements& u) {
    double largest = 0;
    for (const Vec3d& one : u) largest = std::max(largest, fccda::largest_magnitude(one));
    largest = body_.particles.share().ranks().max(largest);
    // strains of 1e-6: linear to the same accuracy, with relative rounding of 1e-9
    const double scale = 1e-6 * body_.particles.spacing() / largest;
    Particles& particles = body_.particles;
    for (std::size_t n = 0; n < size(); ++n) particles.position.set(slot(n), particles.reference(slot(n)) + scale * u[n]);
    particles.refresh_ghosts();
    body_.internal.evaluate_unbroken(particles, body_.family);
    Displacements product(size());
    for (std::size_t n = 0; n < size(); ++n) product[n] = (-1 / (scale * densities_[slot(n)])) * particles.force_density.at(slot(n));
    return product;
  }

  Displacements random() const {
    Displacements start(size());
    for (std::size_t n = 0; n < size(); ++n) {
      const std::uint64_t whole = body_.particles.share().whole_slot(slot(n));  // the same number of a particle on any rank
      const auto number = [&](std::uint64_t c) { return uniform_of(1, 3 * whole + c) - 0.5; };
      start[n] = {number(0), number(1), body_.particles.is_plane() ? 0 : number(2)};
    }
    return start;
  }

 private:
  std::size_t slot(std::size_t n) const { return body_.particles.slot_of()[n]; }

  Body body_;
  std::vector<double> densities_;  // [kg/m³] of each slot
};

/// Largest eigenvalue of the symmetric tridiagonal matrix with this diagonal and off-diagonal, by bisection: below it the pivots of
/// (matrix - value) are not all negative (Golub and Van Loan, 8.4).
double largest_eigenvalue(const std::vector<double>& diagonal, const std::vector<double>& beside) {
  double low = 0, high = 0;
  for (std::size_t n = 0; n < diagonal.size(); ++n) high = std::max(high, diagonal[n] + (n > 0 ? beside[n - 1] : 0) + (n < beside.size() ? beside[n] : 0));
  const auto is_above_all = [&](double value) {
    double pivot = diagonal[0] - value;
    for (std::size_t n = 1; pivot < 0 && n < diagonal.size(); ++n) pivot = diagonal[n] - value - beside[n - 1] * beside[n - 1] / pivot;
    return pivot < 0;
  };
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (is_above_all(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace

double stiffest_mode(const Body& body, int products) { return stiffest_mode(body, std::vector(body.particles.slots(), body.particles.density()), products); }

double stiffest_mode(const Body& body, std::vector<double> densities, int products) {
  Stiffness stiffness(body, std::move(densities));
  Displacements current = stiffness.random(), previous(stiffness.size());
  std::vector<double> diagonal, beside;
  double length = std::sqrt(stiffness.inner(current, current));
  for (int step = 0; step < products; ++step) {
    for (Vec3d& one : current) one *= 1 / length;
    Displacements next = stiffness.times(current);
    const double own = stiffness.inner(current, next), last = beside.empty() ? 0 : beside.back();
    for (std::size_t n = 0; n < next.size(); ++n) next[n] -= own * current[n] + last * previous[n];
    diagonal.push_back(own);
    length = std::sqrt(stiffness.inner(next, next));
    // only rounding remains if the body has no more modes
    if (!(length > 1e-8 * std::max(own, last))) break;
    beside.push_back(length);
    previous = std::move(current);
    current = std::move(next);
  }
  beside.resize(diagonal.size() - 1);
  return largest_eigenvalue(diagonal, beside);
}

}  // namespace perimpact
