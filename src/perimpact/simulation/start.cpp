#include "perimpact/simulation/start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/impactor/in_plane.hpp"
#include "perimpact/simulation/expect_parts.hpp"
#include "perimpact/simulation/memory.hpp"

namespace perimpact {

namespace {

std::vector<Particles> fill(const Setup& setup, std::span<const Discretisation> bodies, fccda::Stages& stages, Ranks& ranks,
                            std::span<const MeasuredLoad> loads) {
  std::vector<Particles> particles;
  RanksInTurn in_turn(ranks.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    stages.begin("particles", setup.bodies[b].name);
    const Share& share = particles.emplace_back(make_particles(setup.bodies[b], bodies[b], ranks, in_turn.first_rank(), load_of_body(loads, b))).share();
    in_turn.add(share.is_whole() ? ranks.size() : share.parts());
  }
  expect_parts_for_all(in_turn);
  return particles;
}

std::vector<std::optional<FilledMass>> masses_of(std::span<const Discretisation> bodies, std::span<const Particles> particles) {
  std::vector<std::optional<FilledMass>> masses(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto* solid = std::get_if<BodySolid>(&bodies[b]);
    const std::optional<double> volume = solid ? solid->volume() : std::nullopt;
    if (volume) masses[b] = FilledMass{particles[b].material_density() * *volume, particles[b].total_mass()};
  }
  return masses;
}

std::vector<Impactor> place(const Setup& setup, std::vector<ImpactorSurface> surfaces, std::span<Particles> particles, fccda::Stages& stages) {
  std::vector<Particles*> bodies;
  for (Particles& body : particles) bodies.push_back(&body);
  std::vector<Impactor> impactors;
  for (std::size_t i = 0; i < setup.impactors.size(); ++i) {
    const ImpactorSetup& impactor = setup.impactors[i];
    stages.begin("detectors", impactor.name);
    impactors.emplace_back(impactor, setup.contact.impactors, bodies, std::move(surfaces[i]));
    for (const Particles& body : particles)
      if (body.is_plane()) expect_in_plane(impactor, impactors.back(), body, (1 + setup.contact.impactors.radius_ratio) * body.spacing());
  }
  return impactors;
}

/// Slots of the body currently inside the impactor, by a step of zero duration.
std::vector<std::size_t> inside_now(const Impactor& impactor, std::size_t body, Particles& particles, const ImpactorContactSetup& contact) {
  return impactor.initial_overlap(body, ContactParticles(particles, contact, {}, 0));
}

/// Calls visit(impactor, body, slots of this rank, their number on all ranks) for each pair that overlaps on any rank.
template <class Visit>
void for_each_inside(Start& start, const ImpactorContactSetup& contact, const Visit& visit) {
  for (std::size_t i = 0; i < start.impactors.size(); ++i)
    for (std::size_t b = 0; b < start.particles.size(); ++b) {
      std::vector<std::size_t> slots = inside_now(start.impactors[i], b, start.particles[b], contact);
      const auto all = static_cast<std::size_t>(start.ranks->sum(static_cast<std::int64_t>(slots.size())));
      if (all > 0) visit(i, b, std::move(slots), all);
    }
}

void refuse(Start& start, const Setup& setup) {
  for_each_inside(start, setup.contact.impactors, [&](std::size_t i, std::size_t b, const std::vector<std::size_t>&, std::size_t all) {
    const std::string& impactor = setup.impactors[i].name;
    throw SetupError("impactors." + impactor + ".position",
                     fmt::format("impactor {} starts inside body {}: {} particles are inside its surface, or nearer to it than the contact radius. Move it "
                                 "away, check the units of its surface, or set contact.impactors.initial_overlap: remove or project.",
                                 impactor, setup.bodies[b].name, all));
  });
}

void remove(Start& start, const Setup& setup) {
  for_each_inside(start, setup.contact.impactors, [&](std::size_t i, std::size_t b, std::vector<std::size_t> slots, std::size_t all) {
    if (all == start.particles[b].size_of_body())
      throw SetupError("impactors." + setup.impactors[i].name + ".position",
                       fmt::format("all remaining particles of body {} are inside impactor {}, so that initial_overlap: remove leaves nothing of it. Move the "
                                   "impactor away, or check the units of its surface.",
                                   setup.bodies[b].name, setup.impactors[i].name));
    start.particles[b].remove(slots);
    start.inside.push_back({i, b, std::move(slots), all});
  });
}

/// A particle projected out of one impactor may be in another, hence the rounds. It is counted for every impactor.
void project(Start& start, const Setup& setup) {
  constexpr int most_rounds = 4;
  for (int round = 0; round < most_rounds; ++round)
    for_each_inside(start, setup.contact.impactors, [&](std::size_t i, std::size_t b, const std::vector<std::size_t>& slots, std::size_t) {
      Particles& particles = start.particles[b];
      std::vector<Vec3d> places;
      for (const std::size_t slot : slots) places.push_back(particles.position.at(slot));
      const std::vector<std::optional<Vec3d>> outside = start.impactors[i].nearest_outside(b, places);
      if (!start.ranks->any(std::ranges::any_of(outside, [](const auto& place) { return place.has_value(); }))) return;
      auto entry =
          std::find_if(start.inside.begin(), start.inside.end(), [&](const InitialPenetration& known) { return known.impactor == i && known.body == b; });
      if (entry == start.inside.end()) entry = start.inside.insert(entry, {i, b, {}});
      for (std::size_t k = 0; k < slots.size(); ++k) {
        if (!outside[k]) continue;
        particles.position.set(slots[k], *outside[k]);
        entry->slots.push_back(slots[k]);
      }
      std::sort(entry->slots.begin(), entry->slots.end());
      entry->slots.erase(std::unique(entry->slots.begin(), entry->slots.end()), entry->slots.end());
    });
  for (InitialPenetration& entry : start.inside) {
    for (const std::size_t slot : entry.slots) entry.furthest = std::max(entry.furthest, norm(start.particles[entry.body].displacement(slot)));
    entry.furthest = start.ranks->max(entry.furthest);
    entry.particles = static_cast<std::size_t>(start.ranks->sum(static_cast<std::int64_t>(entry.slots.size())));
  }
  for_each_inside(start, setup.contact.impactors, [&](std::size_t i, std::size_t b, const std::vector<std::size_t>&, std::size_t all) {
    throw SetupError("impactors." + setup.impactors[i].name + ".position",
                     fmt::format("{} particles of body {} that start inside impactor {} cannot be projected onto its surface, because no position near them is "
                                 "outside all impactors. Set initial_overlap: remove, or move the impactor away.",
                                 all, setup.bodies[b].name, setup.impactors[i].name));
  });
}

}  // namespace

Start::Read Start::read(const Setup& setup, fccda::Stages& stages, const Ranks& ranks, std::span<const MeasuredLoad> loads) {
  Read all;
  for (const BodySetup& body : setup.bodies) {
    stages.begin("solids and points", body.name);
    all.bodies.push_back(discretise(body));
  }
  Memory memory = memory_of(setup, all.bodies);
  memory.reduce_to(share_of_memory(setup, all.bodies, ranks, loads));
  const AvailableMemory available = available_memory();
  expect_to_fit(setup, all.bodies, memory, available);
  for (const ImpactorSetup& impactor : setup.impactors) {
    stages.begin("surfaces", impactor.name);
    all.surfaces.push_back(surface_of(impactor));
    memory.add(all.surfaces.back().remeshed.surface);
    expect_to_fit(setup, all.bodies, memory, available);
  }
  return all;
}

Start::Start(const Setup& setup, fccda::Stages given, Ranks& all, std::span<const MeasuredLoad> loads)
    : Start(setup, given, read(setup, given, all, loads), all, loads) {}

Start::Start(const Setup& setup, fccda::Stages& given, Read read, Ranks& all, std::span<const MeasuredLoad> loads)
    : ranks(&all),
      stages(std::move(given)),
      particles(fill(setup, read.bodies, stages, all, loads)),
      filled_masses(masses_of(read.bodies, particles)),
      impactors(place(setup, std::move(read.surfaces), particles, stages)) {
  if (!impactors.empty()) stages.begin("initial overlap");
  switch (setup.contact.impactors.initial_overlap.as<InitialOverlap>()) {
    case InitialOverlap::error:
      refuse(*this, setup);
      break;
    case InitialOverlap::remove:
      remove(*this, setup);
      break;
    case InitialOverlap::project:
      project(*this, setup);
      break;
  }
  stages.end();
}

double largest_stretch(const Body& body, std::span<const std::size_t> slots) {
  double largest = 0;
  for (const std::size_t slot : slots)
    body.family.for_each_bond(slot, [&](const FamilyBond& bond) {
      const double length = norm(body.particles.position.at(bond.j) - body.particles.position.at(slot));
      largest = std::max(largest, std::fabs(length / bond.length - 1));
    });
  return body.particles.share().ranks().max(largest);
}

std::vector<std::string> warnings_of(std::span<const InitialPenetration> inside, const Setup& setup, std::span<const Body> bodies) {
  std::vector<std::string> warnings;
  for (const InitialPenetration& entry : inside) {
    const std::string where =
        fmt::format("Impactor {} starts inside body {}: {} particles that were inside its surface, or nearer to it than the contact radius,",
                    setup.impactors[entry.impactor].name, bodies[entry.body].name, entry.particles);
    if (setup.contact.impactors.initial_overlap.as<InitialOverlap>() == InitialOverlap::remove)
      warnings.push_back(fmt::format("{} were removed; the body has a hole there.", where));
    else
      warnings.push_back(
          fmt::format("{} were projected onto it, by at most {:.3g} m. Bonds start with stretches up to {:.2g}, so that the body is not at rest. Move the "
                      "impactor away if this is too much.",
                      where, entry.furthest, largest_stretch(bodies[entry.body], entry.slots)));
  }
  return warnings;
}

}  // namespace perimpact
