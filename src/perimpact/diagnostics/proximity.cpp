#include "perimpact/diagnostics/proximity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/grouped_sentences.hpp"
#include "base/parallel.hpp"

namespace perimpact {

namespace {

/// Smallest distance of particle centres from the surface, at most `cap` [m].
double nearest_distance(const fccda::Bvh& tree, const fccda::Pose& pose, const Particles& particles, double cap) {
  constexpr std::size_t block = 4096;
  const auto slots = particles.slot_of();
  std::vector<double> nearest((slots.size() + block - 1) / block, cap);
  fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>(nearest.size()), [&](std::ptrdiff_t k) {
    double& least = nearest[static_cast<std::size_t>(k)];
    const std::size_t begin = static_cast<std::size_t>(k) * block, end = std::min(begin + block, slots.size());
    std::size_t tested = 0;
    int guess = -1;
    for (std::size_t i = begin; i < end; ++i)
      if (const auto closest = tree.closest(pose.to_body(particles.position.at(slots[i])), least, guess, tested)) {
        least = closest->distance;
        guess = closest->triangle;
      }
  });
  const double own = nearest.empty() ? cap : *std::min_element(nearest.begin(), nearest.end());
  return particles.share().ranks().min(own);
}

}  // namespace

void ProximityMonitor::sample(std::span<const Body> bodies, std::span<const Impactor> impactors, double contact_ratio, double time) {
  of_impactor_.resize(impactors.size(), std::vector<Proximity>(bodies.size()));
  trees_.resize(impactors.size());
  time_ = time;
  for (std::size_t i = 0; i < impactors.size(); ++i) {
    const Impactor& impactor = impactors[i];
    bool all_were_in_contact = true;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      Proximity& proximity = of_impactor_[i][b];
      if (bodies[b].particles.share().ranks().any(impactor.entered_inside(b) > 0) && !proximity.entered_by) proximity.entered_by = time;
      if (impactor.record().was_in_contact(b)) continue;
      all_were_in_contact = false;
      if (!trees_[i]) trees_[i] = std::make_unique<fccda::Bvh>(impactor.surface());
      const double radius = contact_ratio * bodies[b].particles.spacing();
      const double distance = nearest_distance(*trees_[i], impactor.body().pose(), bodies[b].particles, proximity.nearest + radius) - radius;
      // of distances equal up to rounding, the first is kept
      if (std::isinf(proximity.nearest) || distance < proximity.nearest - 1e-9 * std::fabs(proximity.nearest))
        proximity.nearest = distance, proximity.nearest_time = time;
    }
    if (all_were_in_contact) trees_[i].reset();
  }
}

bool ProximityMonitor::reads(std::size_t body, std::span<const Impactor> impactors) {
  return !std::ranges::all_of(impactors, [&](const Impactor& impactor) { return impactor.record().was_in_contact(body); });
}

std::vector<std::string> ProximityMonitor::warnings(std::span<const Body> bodies, std::span<const Impactor> impactors) const {
  fccda::GroupedSentences warnings;
  for (const std::string& sentence : warnings_of_distance(bodies, impactors)) warnings.add(sentence, "", sentence);
  for (std::size_t i = 0; i < of_impactor_.size(); ++i)
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const Proximity& proximity = of_impactor_[i][b];
      const std::string &impactor = impactors[i].name(), &body = bodies[b].name;
      const std::string pair = fmt::format("{} with {}", impactor, body);
      if (proximity.entered_by)
        warnings.add(
            "entered", pair,
            fmt::format("{} particles of body {} penetrated impactor {} outside the contact bounds, the first by t = {:.4g} s, and had no contact. {}",
                        bodies[b].particles.share().ranks().sum(static_cast<std::int64_t>(impactors[i].entered_inside(b))), body, impactor,
                        *proximity.entered_by,
                        impactors[i].surface().is_closed() ? fmt::format("Enlarge impactors.{}.contact_bounds.", impactor)
                                                           : fmt::format("They passed the boundary edge of its open surface, or impactors.{}.contact_bounds; "
                                                                         "extend them, or, if its normals point to the wrong side, set orientation.",
                                                                         impactor)));
      if (const UnresolvedPenetration& unresolved = impactors[i].unresolved(b); unresolved.count > 0)
        warnings.add(
            "unresolved_penetrations", pair,
            fmt::format("Particles of body {} were pinched between impactor {} and others, first at t = {:.4g} s: summed over steps, {} penetrations remained, "
                        "because no position outside all impactors was found. Forces on impactors are unreliable where they close in on a body by more than it "
                        "can deform; check their motions, or keep them at least two spacings apart.",
                        body, impactor, unresolved.first, unresolved.count));
    }
  return warnings.sentences();
}

std::vector<std::string> ProximityMonitor::warnings_of_distance(std::span<const Body> bodies, std::span<const Impactor> impactors) const {
  struct Pair {
    std::size_t impactor, body;
  };
  std::vector<Pair> apart;
  for (std::size_t i = 0; i < of_impactor_.size(); ++i)
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (!impactors[i].record().was_in_contact(b)) apart.push_back({i, b});
  const auto of = [&](const Pair& pair) -> const Proximity& { return of_impactor_[pair.impactor][pair.body]; };
  if (apart.size() > fccda::GroupedSentences::most) {
    const Pair nearest = *std::min_element(apart.begin(), apart.end(), [&](const Pair& a, const Pair& b) { return of(a).nearest < of(b).nearest; });
    return {
        fmt::format("{} of {} pairs of an impactor and a body had no contact until t = {:.4g} s. The smallest distance was {:.3g} m, of impactor {} from body "
                    "{} at t = {:.4g} s. Check positions, velocities, units and contact bounds, or run longer.",
                    apart.size(), impactors.size() * bodies.size(), time_, std::max(of(nearest).nearest, 0.0), impactors[nearest.impactor].name(),
                    bodies[nearest.body].name, of(nearest).nearest_time)};
  }
  std::vector<std::string> warnings;
  for (const Pair& pair : apart)
    warnings.push_back(fmt::format(
        "Impactor {} had no contact with body {} until t = {:.4g} s: the smallest distance was {:.3g} m, at t = {:.4g} s. Check position, "
        "velocity, units and contact bounds{}, or run longer.",
        impactors[pair.impactor].name(), bodies[pair.body].name, time_, std::max(of(pair).nearest, 0.0), of(pair).nearest_time,
        impactors[pair.impactor].surface().is_closed() ? "" : "; also check the outer side of its open surface (orientation: normals or reversed)"));
  return warnings;
}

}  // namespace perimpact
