#include "perimpact/materials/internal_force.hpp"

namespace perimpact {

using fccda::NativePack;

InternalForce::InternalForce(Kind kind, const Particles& particles) : kind_(std::move(kind)), share_(particles.share()) {
  const std::size_t eights = particles.slots() / fccda::byte_lanes;
  sums_.energy.assign(eights, 0);
  sums_.broken_ends.assign(eights, 0);
  sums_.fracture_energy.assign(eights, 0);
}

void InternalForce::pass(Particles& particles, Family& family, const PassOptions& options) {
  std::visit(
      [&](auto& force) {
        if (is_scalar_)
          force.template pass<double>(particles, family, options, sums_);
        else
          force.template pass<NativePack>(particles, family, options, sums_);
      },
      kind_);
}

void InternalForce::evaluate(Particles& particles, Family& family, double dt) { pass(particles, family, {.dt = dt}); }

double InternalForce::evaluate_with_energy(Particles& particles, Family& family, double dt) {
  pass(particles, family, {.with_energy = true, .dt = dt});
  return elastic_energy();
}

void InternalForce::evaluate_unbroken(Particles& particles, Family& family) { pass(particles, family, {.may_break = false}); }

void InternalForce::evaluate_scalar(Particles& particles, Family& family, double dt) {
  std::visit([&](auto& force) { force.template pass<double>(particles, family, {.dt = dt}, sums_); }, kind_);
}

std::size_t InternalForce::broken_bonds() const {
  std::size_t ends = 0;
  for (const std::size_t count : sums_.broken_ends) ends += count;
  return static_cast<std::size_t>(share_.ranks().sum(static_cast<std::int64_t>(ends))) / 2;
}

double InternalForce::fracture_energy() const { return exact_sum(share_.ranks(), sums_.fracture_energy); }

const Correspondence* InternalForce::correspondence() const {
  if (const auto* space = std::get_if<CorrespondenceForce<3>>(&kind_)) return &space->law();
  if (const auto* plane = std::get_if<CorrespondenceForce<2>>(&kind_)) return &plane->law();
  return nullptr;
}

double InternalForce::bytes() const {
  const auto of_eights = static_cast<double>(SumsOfEights::bytes_of_eight * sums_.energy.size());
  return of_eights + std::visit([](const auto& force) { return force.bytes(); }, kind_);
}

}  // namespace perimpact
