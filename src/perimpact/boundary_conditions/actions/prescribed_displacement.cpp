#include "perimpact/boundary_conditions/actions/prescribed_displacement.hpp"

#include <algorithm>
#include <cmath>

#include "perimpact/particles/advance.hpp"

namespace perimpact {

void PrescribedDisplacement::set_initial_state(Particles& particles, double time, Regime pace) const {
  for (std::size_t c = 0; c < 3; ++c) {
    if (!histories_[c]) continue;
    const double displacement = histories_[c]->displacement(time), velocity = pace == Regime::quasi_static ? 0 : histories_[c]->velocity(time, time);
    for (const std::uint32_t slot : slots_) {
      particles.position.component(c)[slot] = particles.reference(slot)[c] + displacement;
      particles.velocity.component(c)[slot] = velocity;
    }
  }
}

PrescribedMotion PrescribedDisplacement::motion(const fccda::Step& step) const {
  PrescribedMotion motion{};
  for (std::size_t c = 0; c < 3; ++c)
    if (histories_[c])
      motion.constrains[c] = true, motion.displacement[c] = histories_[c]->displacement(step.t1),
      motion.velocity[c] = histories_[c]->velocity(step.t0, step.t1);
  return motion;
}

void PrescribedDisplacement::impose_displacements(Particles& particles, const fccda::Step& step, std::span<double> travel) const {
  const PrescribedMotion motion = this->motion(step);
  for (const std::uint32_t slot : slots_) {
    motion.impose(slot, particles.reference(slot), particles.position.writable_pointers(), particles.velocity.writable_pointers());
    double& furthest = travel[slot / travel_block];
    furthest = std::max(furthest, norm(particles.velocity.at(slot)) * step.dt);
  }
}

void PrescribedDisplacement::reimpose_after_contact(Particles& particles, const fccda::Step& step, std::span<const std::uint32_t> changed,
                                                    std::vector<std::uint32_t>& displaced) {
  const PrescribedMotion motion = this->motion(step);
  struct Changes {
    Vec3d impulse;            // [N s]
    double work, correction;  // [J]
  };
  fccda::ExactSums<Changes> changes;
  const std::size_t displaced_before = displaced.size();
  for (const std::uint32_t slot : changed) {
    if (!std::binary_search(slots_.begin(), slots_.end(), slot)) continue;
    Vec3d change{}, unbalanced{};  // [m/s]
    for (std::size_t c = 0; c < 3; ++c) {
      if (!motion.constrains[c]) continue;
      change[c] = motion.velocity[c] - particles.velocity.component(c)[slot];
      unbalanced[c] = -0.5 * (change[c] + step.dt / particles.density() * particles.force_density.component(c)[slot]);
    }
    motion.impose(slot, particles.reference(slot), particles.position.writable_pointers(), particles.velocity.writable_pointers());
    if (change == Vec3d{}) continue;
    const Vec3d impulse = particles.mass(slot) * change;
    changes.add({impulse, dot(impulse, motion.velocity), dot(impulse, unbalanced)});
    displaced.push_back(slot);
  }
  Ranks& ranks = particles.share().ranks();
  if (!ranks.any(displaced.size() != displaced_before)) return;
  const Changes sum = value_of_all(ranks, changes);
  account.add(sum.impulse, sum.work);
  constraint_work_correction_ += sum.correction;
}

template <class Target>
ForceSum PrescribedDisplacement::take_over(Particles& particles, const Target& target) const {
  return exact_sum_over_eights(particles.share().ranks(), slots_, [&](std::size_t k) {
    const std::size_t slot = slots_[k];
    Vec3d force{};
    for (std::size_t c = 0; c < 3; ++c) {
      if (!histories_[c]) continue;
      double& density = particles.force_density.component(c)[slot];
      const double wanted = target(slot, c);
      force[c] = particles.volume(slot) * (wanted - density);
      density = wanted;
    }
    return ForceSum{force, squared_norm(force)};
  });
}

ForceSum PrescribedDisplacement::constrain(Particles& particles, const fccda::Step& next) const {
  const PrescribedMotion motion = this->motion(next);
  const double scale = particles.density() / next.dt;
  return take_over(particles, [&](std::size_t slot, std::size_t c) { return motion.force_density(scale, c, particles.velocity.component(c)[slot]); });
}

ForceSum PrescribedDisplacement::constrain_statically(Particles& particles) const {
  return take_over(particles, [](std::size_t, std::size_t) { return 0.0; });
}

Vec3d PrescribedDisplacement::displacement(double time) const {
  Vec3d displacement{};
  for (std::size_t c = 0; c < 3; ++c)
    if (histories_[c]) displacement[c] = histories_[c]->displacement(time);
  return displacement;
}

}  // namespace perimpact
