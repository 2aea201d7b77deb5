#include "perimpact/materials/internal_force.hpp"

namespace perimpact {

using fccda::NativePack;

InternalForce::InternalForce(Kind kind, const Particles& particles) : kind_(std::move(kind)) {
  rows_.energy.assign(particles.rows(), 0);
  rows_.broken_ends.assign(particles.rows(), 0);
  rows_.fracture_energy.assign(particles.rows(), 0);
}

void InternalForce::evaluate(Particles& particles, Family& family, double dt) {
  std::visit([&](auto& force) { force.template pass<NativePack>(particles, family, {.dt = dt}, rows_); }, kind_);
}

double InternalForce::evaluate_with_energy(Particles& particles, Family& family, double dt) {
  std::visit([&](auto& force) { force.template pass<NativePack>(particles, family, {.with_energy = true, .dt = dt}, rows_); }, kind_);
  double sum = 0;
  for (const double energy : rows_.energy) sum += energy;
  return sum;
}

void InternalForce::evaluate_unbroken(Particles& particles, Family& family) {
  std::visit([&](auto& force) { force.template pass<NativePack>(particles, family, {.may_break = false}, rows_); }, kind_);
}

void InternalForce::evaluate_scalar(Particles& particles, Family& family, double dt) {
  std::visit([&](auto& force) { force.template pass<double>(particles, family, {.dt = dt}, rows_); }, kind_);
}

std::size_t InternalForce::broken_bonds() const {
  std::size_t ends = 0;
  for (const std::size_t count : rows_.broken_ends) ends += count;
  return ends / 2;
}

double InternalForce::fracture_energy() const {
  double sum = 0;
  for (const double energy : rows_.fracture_energy) sum += energy;
  return sum;
}

const Correspondence* InternalForce::correspondence() const {
  if (const auto* space = std::get_if<CorrespondenceForce<3>>(&kind_)) return &space->law();
  if (const auto* plane = std::get_if<CorrespondenceForce<2>>(&kind_)) return &plane->law();
  return nullptr;
}

double InternalForce::bytes() const {
  return std::visit([](const auto& force) { return force.bytes(); }, kind_);
}

}  // namespace perimpact
