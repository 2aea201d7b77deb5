#include "perimpact/boundary_conditions/boundary_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

namespace {

NamedBoundaryCondition make_named(const BoundaryConditionSetup& boundary, const BoundedParticles& of) {
  return std::visit(
      [&]<class Kind>(const Kind& kind) {
        const BoundarySite site{of, fmt::format("bodies.{}.boundary_conditions.{}.{}", of.body.name, boundary.name, Kind::name)};
        return NamedBoundaryCondition{fmt::format("{}.{}", of.body.name, boundary.name), Kind::name, make_boundary(kind, site)};
      },
      boundary.kind);
}

}  // namespace

/// Calls act(action) for the actions for which it can be called.
template <class Act>
void BoundaryConditions::for_each(const Act& act) {
  for (NamedBoundaryCondition& one : all_)
    std::visit(
        [&](auto& boundary) {
          if constexpr (std::is_invocable_v<const Act&, decltype(boundary)>) act(boundary);
        },
        one.boundary);
}

BoundaryConditions::BoundaryConditions(const BodySetup& body, const IsotropicElastic& elastic, const Particles& particles, const SlotsOfRegion& slots_of)
    : share_(particles.share()) {
  for (const BoundaryConditionSetup& boundary : body.boundary_conditions) all_.push_back(make_named(boundary, {body, elastic, particles, slots_of}));
  refuse_constrained_twice(body, particles);
  refuse_floating_twice(body, particles);
  for_each([&](const PrescribedDisplacement& constraint) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (constraint.constrains(axis))
        for_each([&](auto& other) {
          if constexpr (requires { other.leave_out(constraint.slots(), axis); }) other.leave_out(constraint.slots(), axis);
        });
  });
}

void BoundaryConditions::add(NamedBoundaryCondition boundary) {
  for (const NamedBoundaryCondition& one : all_)
    if (one.name == boundary.name)
      throw SetupError(
          "bodies." + boundary.name,
          fmt::format("{} is already the name of a boundary condition, whose columns in history.csv it would share; choose another.", boundary.name));
  all_.push_back(std::move(boundary));
}

void BoundaryConditions::refuse_constrained_twice(const BodySetup& body, const Particles& particles) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<int> constrained_by(particles.slots(), -1);
    for (std::size_t k = 0; k < all_.size(); ++k) {
      const auto* constraint = std::get_if<PrescribedDisplacement>(&all_[k].boundary);
      if (!constraint || !constraint->constrains(axis)) continue;
      for (const std::uint32_t slot : constraint->slots()) {
        if (constrained_by[slot] < 0) {
          constrained_by[slot] = static_cast<int>(k);
          continue;
        }
        const std::string& name = body.boundary_conditions[k].name;
        throw SetupError(fmt::format("bodies.{}.boundary_conditions.{}", body.name, name),
                         fmt::format("{} constrains particles of body {} in direction {} that {} constrains too; separate their particle sets, or remove the "
                                     "direction from one of the two.",
                                     name, body.name, axis_words[axis], body.boundary_conditions[static_cast<std::size_t>(constrained_by[slot])].name));
      }
    }
  }
}

void BoundaryConditions::refuse_floating_twice(const BodySetup& body, const Particles& particles) const {
  std::vector<std::uint8_t> hydrostatics(particles.slots(), 0);
  for (std::size_t k = 0; k < all_.size(); ++k) {
    const auto* water = std::get_if<Floating>(&all_[k].boundary);
    if (!water) continue;
    for (const std::uint32_t slot : water->slots()) {
      if (hydrostatics[slot] != 0)
        throw SetupError(fmt::format("bodies.{}.boundary_conditions.{}", body.name, body.boundary_conditions[k].name),
                         fmt::format("{} applies weight and buoyancy to particles of body {} that another floating boundary condition includes; separate their "
                                     "particle sets, or remove one of the two.",
                                     body.boundary_conditions[k].name, body.name));
      hydrostatics[slot] = 1;
    }
  }
}

void BoundaryConditions::set_initial_state(Particles& particles, double time, PrescribedDisplacement::Regime pace) {
  for_each([&](const PrescribedDisplacement& constraint) { constraint.set_initial_state(particles, time, pace); });
}

void BoundaryConditions::update_exposed_surface(const Particles& particles, const Family& family, std::span<const std::uint32_t> broken_ends) {
  for_each([&](auto& one) {
    if constexpr (requires { one.update_exposed_surface(particles, family, broken_ends); }) one.update_exposed_surface(particles, family, broken_ends);
  });
}

void BoundaryConditions::add_forces(Particles& particles, const fccda::Step& next) {
  for_each([&](auto& one) {
    if constexpr (requires { one.apply_load(particles, next); }) one.apply_load(particles, next);
  });
  for_each([&](auto& one) {
    if constexpr (requires { one.apply_hydrostatics(particles); }) one.apply_hydrostatics(particles);
  });
  for_each([&](auto& one) {
    if constexpr (requires { one.damp(particles, next.dt); }) one.damp(particles, next.dt);
  });
  for_each([&](auto& one) {
    if constexpr (requires { one.apply_resistance(particles, next.dt); }) one.apply_resistance(particles, next.dt);
  });
  for_each([&](auto& one) {
    if constexpr (requires { one.apply_constraint(particles, next); }) one.apply_constraint(particles, next);
  });
}

void BoundaryConditions::impose_displacements(Particles& particles, const fccda::Step& step, std::span<double> travel) {
  for (NamedBoundaryCondition& one : all_) one.account().accumulate_impulse(step.dt);
  for_each([&](const PrescribedDisplacement& constraint) { constraint.impose_displacements(particles, step, travel); });
}

std::vector<std::uint32_t> BoundaryConditions::respond_to_contact(Particles& particles, const fccda::Step& step, std::vector<std::uint32_t> changed) {
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  for_each([&](Floating& water) { water.exclude_from_added_mass(changed); });
  std::vector<std::uint32_t> displaced;
  for_each([&](PrescribedDisplacement& constraint) { constraint.reimpose_after_contact(particles, step, changed, displaced); });
  return displaced;
}

double BoundaryConditions::balance(Particles& particles, double time) {
  balanced_.assign(all_.size(), {});
  const auto phase = [&](const auto& set_force) {
    for (std::size_t k = 0; k < all_.size(); ++k) std::visit([&](auto& one) { set_force(one, balanced_[k]); }, all_[k].boundary);
  };
  phase([&](auto& one, ForceSum& force) {
    if constexpr (requires { one.static_load(particles, time); }) force = one.static_load(particles, time);
  });
  phase([&](auto& one, ForceSum& force) {
    if constexpr (requires { one.static_hydrostatics(particles); }) force = one.static_hydrostatics(particles);
  });
  phase([&](auto& one, ForceSum& force) {
    if constexpr (requires { one.constrain_statically(particles); }) force = one.constrain_statically(particles);
  });
  double squared = 0;
  for (const ForceSum& sum : balanced_) squared += sum.squared;
  return std::sqrt(squared);
}

void BoundaryConditions::accept_equilibrium(const Particles& particles, double time, double dt) {
  for (std::size_t k = 0; k < all_.size(); ++k) {
    std::visit(
        [&](auto& one) {
          if constexpr (requires { one.conjugate_displacement(particles, time); })
            one.account.record_force(balanced_[k].force, one.conjugate_displacement(particles, time));
          if constexpr (requires { one.flood_deep_columns(particles); }) one.flood_deep_columns(particles);
        },
        all_[k].boundary);
    all_[k].account().accumulate_impulse(dt);
  }
}

double BoundaryConditions::half_kick(double time, double dt) const {
  double energy = 0;
  for (const NamedBoundaryCondition& one : all_)
    std::visit(
        [&](const auto& boundary) {
          if constexpr (requires { boundary.half_kick(time, dt); }) energy += boundary.half_kick(time, dt);
        },
        one.boundary);
  return energy;
}

void BoundaryConditions::restart_potentials() {
  for (NamedBoundaryCondition& one : all_)
    if (auto* floating = std::get_if<Floating>(&one.boundary)) floating->restart_potential();
}

double BoundaryConditions::work() const {
  double work = 0;
  for (const NamedBoundaryCondition& one : all_) work += one.account().work();
  return work;
}

double BoundaryConditions::constraint_work_correction() const {
  double sum = 0;
  for (const NamedBoundaryCondition& one : all_)
    if (const auto* constraint = std::get_if<PrescribedDisplacement>(&one.boundary)) sum += constraint->constraint_work_correction();
  return sum;
}

}  // namespace perimpact
