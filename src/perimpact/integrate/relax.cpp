#include "perimpact/integrate/relax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "perimpact/integrate/stiffest_mode.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

namespace {

/// Σ_j C_ij v V |n_p| (|n_x| + |n_y| + |n_z|), twice, for the direction p in which it is largest [N/m⁴]: absolute row sum of the
/// stiffness, including the diagonal. C_ij [N/m⁷] is the stiffness of a bond.
double largest_row(const Body& body, std::size_t slot) {
  Vec3d rows{};
  body.family.for_each_bond(slot, [&](const FamilyBond& bond) {
    const Vec3d n{std::fabs(bond.direction.x), std::fabs(bond.direction.y), std::fabs(bond.direction.z)};
    rows += (2 * body.internal.bond_stiffness(slot, bond) * bond.volume * (n.x + n.y + n.z)) * n;
  });
  return std::max({rows.x, rows.y, rows.z});
}

Vec3d vector_at(const std::vector<double>& numbers, std::size_t k) { return {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]}; }

/// Sum of two quantities over particles.
struct Quotient {
  double over = 0, under = 0;
  Quotient& operator+=(const Quotient& other) {
    over += other.over, under += other.under;
    return *this;
  }
};

}  // namespace

std::vector<double> fictitious_density(const Body& body, double dt, double safety) {
  std::vector<double> density(body.particles.slots(), 0);
  const auto slots = body.particles.slot_of();
  fccda::parallel_for(static_cast<std::ptrdiff_t>(slots.size()), [&](std::ptrdiff_t k) {
    const std::size_t slot = slots[static_cast<std::size_t>(k)];
    density[slot] = 0.25 * dt * dt * largest_row(body, slot);
  });
  const double stiffest = body.particles.share().ranks().max(*std::max_element(density.begin(), density.end()));
  for (const std::uint32_t slot : slots)
    if (density[slot] == 0) density[slot] = stiffest > 0 ? stiffest : body.particles.density();  // without bonds
  const double ratio = 0.25 * dt * dt * stiffest_mode(body, density);                            // stability limit at 1
  if (ratio > 0)
    for (const std::uint32_t slot : slots) density[slot] *= safety * ratio;
  return density;
}

Relaxation::Relaxation(const RelaxSetup& setup, std::span<const Body> bodies, double dt, double safety) : setup_(setup), dt_(dt) {
  for (const Body& body : bodies) {
    Search& search = searches_.emplace_back(Search{.particles = &body.particles});
    search.density = fictitious_density(body, dt, safety);
    const Particles& particles = body.particles;
    double furthest = 0;  // [m]
    for (const std::uint32_t slot : particles.slot_of()) furthest = std::max(furthest, largest_magnitude(particles.reference(slot)));
    furthest = particles.share().ranks().max(furthest);
    const double slack = 4 * std::numeric_limits<double>::epsilon() * furthest;  // [m] rounding of a position
    search.rounding = std::sqrt(exact_sum_over_eights(particles, [&](std::size_t slot) {
      const double force = particles.volume(slot) * 4 * search.density[slot] / (dt * dt) * slack;
      return force * force;
    }));
  }
}

std::optional<std::vector<double>> Relaxation::relax(std::span<Body> bodies, std::span<BoundaryConditions> boundary_conditions, long increment, double time,
                                                     const KeepRelaxing& keep_on) {
  if (!under_way_) {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      boundary_conditions[b].set_initial_state(bodies[b].particles, time, PrescribedDisplacement::Regime::quasi_static);
    latest_ = {};
    under_way_ = measures_anew_ = true;
  }
  std::vector<double> energy(bodies.size());
  const auto broken_bonds = [&] {
    std::size_t sum = 0;
    for (const Body& body : bodies) sum += body.internal.broken_bonds();
    return sum;
  };
  while (true) {
    // several ranks complete the increment: they would have to agree on where to stop, and to store it
    const bool is_alone = bodies.front().particles.share().is_whole();
    if (keep_on && !keep_on(latest_) && is_alone) return std::nullopt;
    for (Body& body : bodies) {
      body.particles.refresh_ghosts();
      body.internal.evaluate_unbroken(body.particles, body.family);
    }
    latest_.residual = residual(bodies, boundary_conditions, time);
    if (latest_.residual <= setup_.tolerance) {
      const std::size_t before = broken_bonds();
      for (std::size_t b = 0; b < bodies.size(); ++b) energy[b] = bodies[b].internal.evaluate_with_energy(bodies[b].particles, bodies[b].family);
      latest_.residual = residual(bodies, boundary_conditions, time);
      if (broken_bonds() == before) break;
      measures_anew_ = true;
    }
    if (!std::isfinite(latest_.residual))
      throw fccda::RunError(
          fmt::format("In increment {} (t = {:.6g} s) forces are not finite after {} iterations: the increment is too large; use smaller ones.", increment,
                      time, latest_.iterations));
    if (!(latest_.iterations < setup_.max_iterations))
      throw fccda::RunError(
          fmt::format("Increment {} (t = {:.6g} s) is not in equilibrium after {} iterations: the residual is {:.3g}, but the tolerance is {:.3g}. If a part "
                      "is unconstrained or has broken off, there is no equilibrium; otherwise increase max_iterations, or use smaller increments.",
                      increment, time, latest_.iterations, latest_.residual, setup_.tolerance));
    if (measures_anew_) start(bodies);
    measures_anew_ = false;
    for (std::size_t b = 0; b < bodies.size(); ++b) move(bodies[b], searches_[b]);
    ++latest_.iterations;
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (const std::uint32_t slot : bodies[b].particles.slot_of()) bodies[b].particles.velocity.set(slot, {});
    boundary_conditions[b].accept_equilibrium(bodies[b].particles, time, dt_);
    searches_[b].position0.clear(), searches_[b].force0.clear();
  }
  under_way_ = false;
  return energy;
}

double Relaxation::residual(std::span<Body> bodies, std::span<BoundaryConditions> boundary_conditions, double time) const {
  double largest = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    Particles& particles = bodies[b].particles;
    const double applied = boundary_conditions[b].balance(particles, time);
    const double unbalanced =
        std::sqrt(exact_sum_over_eights(particles, [&](std::size_t slot) { return squared_norm(particles.volume(slot) * particles.force_density.at(slot)); }));
    const double share = unbalanced / (applied + searches_[b].rounding / setup_.tolerance);
    if (!(share <= largest)) largest = share;  // also for NaN
  }
  return largest;
}

void Relaxation::start(std::span<const Body> bodies) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    Search& search = searches_[b];
    search.position0.clear(), search.force0.clear();
    for (const std::uint32_t slot : bodies[b].particles.slot_of()) {
      const Vec3d position = bodies[b].particles.position.at(slot), force = bodies[b].particles.force_density.at(slot);
      search.position0.insert(search.position0.end(), {position.x, position.y, position.z});
      search.force0.insert(search.force0.end(), {force.x, force.y, force.z});
    }
  }
}

double Relaxation::damping(const Body& body, const Search& search) const {
  const Particles& particles = body.particles;
  const Quotient rayleigh = exact_sum_over_eights(particles.share().ranks(), particles.slot_of(), [&](std::size_t k) {
    const std::size_t slot = particles.slot_of()[k];
    const Vec3d u = particles.position.at(slot) - vector_at(search.position0, k);
    return Quotient{dot(u, vector_at(search.force0, k) - particles.force_density.at(slot)), search.density[slot] * squared_norm(u)};
  });
  if (!(rayleigh.over > 0)) return 0;
  return std::min(2 * std::sqrt(rayleigh.over / rayleigh.under), 1.9 / dt_);
}

void Relaxation::move(Body& body, const Search& search) const {
  Particles& particles = body.particles;
  const double c = damping(body, search) * dt_;
  const auto slots = particles.slot_of();
  fccda::parallel_for_blocks(slots.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t slot = slots[k];
      const Vec3d velocity = ((2 - c) * particles.velocity.at(slot) + (2 * dt_ / search.density[slot]) * particles.force_density.at(slot)) / (2 + c);
      particles.velocity.set(slot, velocity);
      particles.position.set(slot, particles.position.at(slot) + dt_ * velocity);
    }
  });
}

}  // namespace perimpact
