#include "perimpact/boundary/boundaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perimpact/setup/setup_error.hpp"

namespace perimpact {

template <class Kind, class Act>
void Boundaries::for_each(const Act& act) {
  for (NamedBoundary& one : all_)
    if (auto* boundary = std::get_if<Kind>(&one.boundary)) act(*boundary);
}

Boundaries::Boundaries(const BodySetup& body, const IsotropicElastic& elastic, const Particles& particles, const SlotsOfRegion& slots_of) {
  for (const BoundarySetup& boundary : body.boundaries) all_.push_back(boundary_of(boundary, {body, elastic, particles, slots_of}));
  refuse_held_twice(body, particles);
  refuse_afloat_twice(body, particles);
  for_each<Held>([&](const Held& held) {
    for_each<Absorbing>([&](Absorbing& layer) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (held.holds(axis)) layer.leave_out(held.slots(), axis);
    });
    for_each<Floating>([&](Floating& water) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (held.holds(axis)) water.leave_out(held.slots(), axis);
    });
  });
}

void Boundaries::add(NamedBoundary boundary) {
  for (const NamedBoundary& one : all_)
    if (one.name == boundary.name)
      throw SetupError("bodies." + boundary.name, fmt::format("{} is the name of a boundary already, and would name the columns of both in history.csv; "
                                                              "choose another.",
                                                              boundary.name));
  all_.push_back(std::move(boundary));
}

void Boundaries::refuse_held_twice(const BodySetup& body, const Particles& particles) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<int> holder(particles.slots(), -1);
    for (std::size_t k = 0; k < all_.size(); ++k) {
      const auto* held = std::get_if<Held>(&all_[k].boundary);
      if (!held || !held->holds(axis)) continue;
      for (const std::uint32_t slot : held->slots()) {
        if (holder[slot] < 0) {
          holder[slot] = static_cast<int>(k);
          continue;
        }
        const std::string& name = body.boundaries[k].name;
        throw SetupError(
            fmt::format("bodies.{}.boundaries.{}", body.name, name),
            fmt::format("{} holds particles of body {} in direction {} that {} holds too; let their regions not overlap, or take the direction out "
                        "of one.",
                        name, body.name, axis_words[axis], body.boundaries[static_cast<std::size_t>(holder[slot])].name));
      }
    }
  }
}

void Boundaries::refuse_afloat_twice(const BodySetup& body, const Particles& particles) const {
  std::vector<std::uint8_t> afloat(particles.slots(), 0);
  for (std::size_t k = 0; k < all_.size(); ++k) {
    const auto* water = std::get_if<Floating>(&all_[k].boundary);
    if (!water) continue;
    for (const std::uint32_t slot : water->slots()) {
      if (afloat[slot] != 0)
        throw SetupError(fmt::format("bodies.{}.boundaries.{}", body.name, body.boundaries[k].name),
                         fmt::format("{} gives particles of body {} weight and water that another floating boundary gives them already; let their regions not "
                                     "overlap, or remove one.",
                                     body.boundaries[k].name, body.name));
      afloat[slot] = 1;
    }
  }
}

void Boundaries::place(Particles& particles, double time, Held::Pace pace) {
  for_each<Held>([&](const Held& held) { held.place(particles, time, pace); });
}

void Boundaries::look(const Particles& particles, const Family& family, std::span<const std::size_t> broken_ends) {
  for_each<Floating>([&](Floating& water) { water.look(particles, family, broken_ends); });
}

void Boundaries::add_forces(Particles& particles, const fccda::Step& next) {
  for_each<Load>([&](Load& load) { load.account.note(load.add_to(particles, next.t0).force, load.displacement(particles)); });
  for_each<OwnForce>([&](OwnForce& own) { own.add_to(particles, next); });
  std::vector<Vec3d> lifts;
  for_each<Floating>([&](Floating& water) { lifts.push_back(water.add_to(particles).force); });
  for_each<Absorbing>([&](Absorbing& layer) { layer.damp(particles, next.dt); });
  auto lift = lifts.begin();
  for_each<Floating>([&](Floating& water) { water.account.note(*lift++ + water.resist(particles, next.dt), {}); });
  for_each<Held>([&](Held& held) { held.account.note(held.hold(particles, next).force, held.displacement(next.t0)); });
}

void Boundaries::lead(Particles& particles, const fccda::Step& step, std::span<double> travel) {
  for (NamedBoundary& one : all_) one.account().act(step.dt);
  for_each<Held>([&](const Held& held) { held.lead(particles, step, travel); });
}

std::vector<std::uint32_t> Boundaries::lead_back(Particles& particles, const fccda::Step& step) {
  std::vector<std::uint32_t> displaced;
  for_each<Held>([&](Held& held) { held.lead_back(particles, step, displaced); });
  return displaced;
}

double Boundaries::balance(Particles& particles, double time) {
  balanced_.assign(all_.size(), {});
  for (std::size_t k = 0; k < all_.size(); ++k)
    if (const auto* load = std::get_if<Load>(&all_[k].boundary)) balanced_[k] = load->add_to(particles, time);
  for (std::size_t k = 0; k < all_.size(); ++k)
    if (auto* water = std::get_if<Floating>(&all_[k].boundary)) balanced_[k] = water->add_to(particles);
  for (std::size_t k = 0; k < all_.size(); ++k)
    if (const auto* held = std::get_if<Held>(&all_[k].boundary)) balanced_[k] = held->hold_still(particles);
  double squared = 0;
  for (const ForceSum& sum : balanced_) squared += sum.squared;
  return std::sqrt(squared);
}

void Boundaries::settle(const Particles& particles, double time, double dt) {
  for (std::size_t k = 0; k < all_.size(); ++k) {
    BoundaryAccount& account = all_[k].account();
    if (auto* load = std::get_if<Load>(&all_[k].boundary)) account.note(balanced_[k].force, load->displacement(particles));
    if (std::holds_alternative<Floating>(all_[k].boundary)) account.note(balanced_[k].force, {});
    if (auto* held = std::get_if<Held>(&all_[k].boundary)) account.note(balanced_[k].force, held->displacement(time));
    account.act(dt);
  }
}

double Boundaries::half_kick(double time, double dt) const {
  double energy = 0;
  for (const NamedBoundary& one : all_) {
    if (const auto* load = std::get_if<Load>(&one.boundary)) energy += load->half_kick(time, dt);
    if (const auto* own = std::get_if<OwnForce>(&one.boundary)) energy += own->half_kick(dt);
  }
  return energy;
}

double Boundaries::work() const {
  double work = 0;
  for (const NamedBoundary& one : all_) work += one.account().work();
  return work;
}

double Boundaries::undone() const {
  double sum = 0;
  for (const NamedBoundary& one : all_)
    if (const auto* held = std::get_if<Held>(&one.boundary)) sum += held->undone();
  return sum;
}

}  // namespace perimpact
