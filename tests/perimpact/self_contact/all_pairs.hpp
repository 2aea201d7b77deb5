// The short-range force by a sum over all pairs, which shares nothing with the code but the law's parameters.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "fixtures/larger.hpp"
#include "perimpact/force/piles.hpp"

namespace fixtures {

using namespace perimpact;

/// Reference: the law of the theory page over all pairs, with its history variables; bonds and surfaces are found independently of the code.
class AllPairs {
 public:
  std::vector<std::vector<Vec3d>> force;  // [N] of each body and slot, of the last evaluation
  double energy = 0, friction_dissipation = 0, damped_work = 0, compaction = 0;
  std::size_t contacts = 0;

  void evaluate(const Pile& pile, double dt) {
    const std::vector<Particle> particles = particles_of(pile);
    const bool plane = pile.bodies[0].particles.is_plane();
    const double dimension = plane ? 2 : 3, face = (1 + 1e-9) * (plane ? 0.2112735 : 0.241455078125), slope = plane ? 0.911014 : 1.118272,
                 oblique = plane ? 1 : 0.9;
    const ShortRangeLaw& law = pile.law;
    std::vector<double> k;
    for (const Body& body : pile.bodies)
      k.push_back(law.stiffness(body.internal.ordinary_state()->law().elastic(), body.family.horizon(), body.particles.thickness().value_or(1)));
    const double together = pile.bodies.size() > 1 ? 2 / (1 / k[0] + 1 / k[1]) : k[0];
    const auto stiffness = [&](const Particle& i, const Particle& j) { return i.body == j.body ? k[i.body] : together; };
    const auto distance = [&](const Particle& i, const Particle& j) { return law.distance_ratio * (i.size + j.size) / 2; };
    const auto share = [&](const Particle& i, double a) { return std::pow(i.size / a, dimension - 1); };
    const auto W = [](double q) { return q < 2 ? std::pow(1 - q * q / 4, 6) : 0; };
    const auto W_slope = [](double q) { return q < 2 ? 3 * q * std::pow(1 - q * q / 4, 5) : 0; };

    // densities
    std::vector<double> own(particles.size()), fresh(particles.size()), others(particles.size());
    std::map<Ends, Vec3d> pairs;
    for (std::size_t a = 0; a < particles.size(); ++a)
      for (std::size_t b = a + 1; b < particles.size(); ++b) {
        const Particle &i = particles[a], &j = particles[b];
        const double d = distance(i, j), r = norm(j.x - i.x);
        if (r >= 2 * d || !(i.exposed || j.exposed) || (i.body == j.body && i.bonds.contains(j.slot))) continue;
        const auto known = slips_.find({a, b});
        pairs[{a, b}] = known == slips_.end() ? Vec3d{} : known->second;
        const double of_j = share(j, d) * W(r / d), of_i = share(i, d) * W(r / d);
        if (i.body != j.body) {
          others[a] += of_j, others[b] += of_i;
          continue;
        }
        own[a] += of_j, own[b] += of_i;
        if (known == slips_.end() && norm(j.x - i.x - dt * (j.v - i.v)) < 2 * d) fresh[a] += of_j, fresh[b] += of_i;
      }
    slips_ = pairs;
    thresholds_.resize(particles.size(), face);
    latest_.resize(particles.size(), 0.0);
    std::vector<double> own_push(particles.size()), other_push(particles.size()), own_B(particles.size()), other_B(particles.size());
    energy = 0;
    for (std::size_t a = 0; a < particles.size(); ++a) {
      const Particle& i = particles[a];
      const double reach = law.distance_ratio * i.size, unit = i.volume * i.volume * reach * reach / (2 * slope * slope);
      double& threshold = thresholds_[a];
      threshold = std::max(face, std::min(threshold, own[a] - fresh[a] + 0.1 * slope));
      double overlap = std::max(0.0, own[a] - fresh[a] - threshold);
      const double most = pile.largest_pressure * i.volume * reach / (2 * slope * i.size) / (k[i.body] * unit);
      if (overlap > most) {
        compaction += (latest_[a] + k[i.body] * unit * most) / 2 * (overlap - most);
        threshold += overlap - most;
        overlap = most;
      }
      latest_[a] = k[i.body] * unit * overlap;
      const double beyond = std::max(0.0, others[a] - face);
      if (own[a] - overlap > threshold && fresh[a] > 0) threshold = own[a] - overlap;
      own_B[a] = k[i.body] * unit, other_B[a] = together * unit;
      own_push[a] = own_B[a] * overlap, other_push[a] = other_B[a] * beyond;
      energy += own_B[a] * overlap * overlap / 2 + other_B[a] * beyond * beyond / 2;
    }

    // forces
    force.clear();
    for (const Body& body : pile.bodies) force.emplace_back(body.particles.slots());
    contacts = 0;
    for (auto& [ends, slip] : slips_) {
      const auto [a, b] = ends;
      const Particle &i = particles[a], &j = particles[b];
      const bool same = i.body == j.body;
      const double push_i = same ? own_push[a] : other_push[a], push_j = same ? own_push[b] : other_push[b];
      const double k_t = stiffness(i, j) * i.volume * j.volume / 6, d = distance(i, j), r = norm(j.x - i.x);
      if (push_i == 0 && push_j == 0) {
        friction_dissipation += k_t * dot(slip, slip) / 2;
        slip = {};
        continue;
      }
      ++contacts;
      const double steep = W_slope(r / d) / d, spring = (push_i * share(j, d) + push_j * share(i, d)) * steep;
      const double K = ((same ? own_B[a] : other_B[a]) * std::pow(share(j, d), 2) + (same ? own_B[b] : other_B[b]) * std::pow(share(i, d), 2)) * steep * steep;
      const Vec3d n = (j.x - i.x) / r, w = j.v - i.v;
      const double apart = dot(w, n), normal = std::max(0.0, spring - 2 * law.damping_ratio * std::sqrt(K / (1 / i.mass + 1 / j.mass)) * apart);
      damped_work += (spring - normal) * apart * dt;
      Vec3d turned = slip - dot(slip, n) * n;
      if (norm(turned) > 0) turned = norm(slip) / norm(turned) * turned;
      const Vec3d reached = turned + dt * (w - apart * n);
      const double most = law.friction * oblique * normal / k_t;
      const Vec3d held = norm(reached) > most ? most / norm(reached) * reached : reached;
      friction_dissipation += std::max(0.0, k_t * dot(turned + held, reached - held) / 2);
      energy += k_t * dot(held, held) / 2;
      slip = held;
      const Vec3d f = k_t * held - normal * n;
      force[i.body][i.slot] += f;
      force[j.body][j.slot] += -f;
    }
  }

 private:
  struct Particle {
    std::size_t body, slot;
    Vec3d X, x, v;
    double size, volume, mass;
    std::set<std::size_t> bonds;
    bool exposed;
  };
  using Ends = std::pair<std::size_t, std::size_t>;

  static std::vector<Particle> particles_of(const Pile& pile) {
    std::vector<Particle> particles;
    for (std::size_t b = 0; b < pile.bodies.size(); ++b) {
      const Body& body = pile.bodies[b];
      const Particles& p = body.particles;
      for (const std::uint32_t slot : p.slot_of()) {
        Particle one{b, slot, p.reference(slot), p.position.at(slot), p.velocity.at(slot), 0, p.volume(slot), p.mass(slot), {}, true};
        one.size = p.is_plane() ? std::sqrt(one.volume / *p.thickness()) : std::cbrt(one.volume);
        body.family.for_each_bond(slot, [&](const FamilyBond& bond) { one.bonds.insert(bond.j); });
        if (p.lattice()) {
          int nearest = 0;
          for (const std::uint32_t other : p.slot_of()) nearest += std::fabs(norm(p.reference(other) - one.X) / p.spacing() - 1) < 1e-6;
          one.exposed = nearest < (p.is_plane() ? 4 : 6) || body.family.damage(slot) > 0;
        }
        particles.push_back(one);
      }
    }
    return particles;
  }

  std::map<Ends, Vec3d> slips_;     // [m] of the pairs that were near
  std::vector<double> thresholds_;  // of each particle
  std::vector<double> latest_;      // [J] B o of each particle
};

/// Largest difference of forces, over the largest force.
inline double difference(const Pile& pile, const AllPairs& expected) {
  double largest = 0, apart = 0;
  for (std::size_t b = 0; b < pile.bodies.size(); ++b)
    for (const std::uint32_t slot : pile.bodies[b].particles.slot_of()) {
      const Particles& particles = pile.bodies[b].particles;
      largest = fixtures::larger(largest, norm(expected.force[b][slot]));
      apart = fixtures::larger(apart, norm(particles.volume(slot) * particles.force_density.at(slot) - expected.force[b][slot]));
    }
  return apart == 0 ? 0 : apart / largest;
}

}  // namespace fixtures
