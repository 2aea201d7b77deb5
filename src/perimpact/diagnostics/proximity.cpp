#include "perimpact/diagnostics/proximity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
    std::size_t asked = 0;
    int guess = -1;
    for (std::size_t i = begin; i < end; ++i)
      if (const auto closest = tree.closest(pose.to_body(particles.position.at(slots[i])), least, guess, asked)) {
        least = closest->distance;
        guess = closest->triangle;
      }
  });
  return nearest.empty() ? cap : *std::min_element(nearest.begin(), nearest.end());
}

}  // namespace

void ProximityMonitor::sample(std::span<const Body> bodies, std::span<const Impactor> impactors, double contact_ratio, double time) {
  of_impactor_.resize(impactors.size(), std::vector<Proximity>(bodies.size()));
  trees_.resize(impactors.size());
  time_ = time;
  for (std::size_t i = 0; i < impactors.size(); ++i) {
    const Impactor& impactor = impactors[i];
    bool all_touched = true;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      Proximity& proximity = of_impactor_[i][b];
      if (!proximity.entered_by && impactor.entered_inside(b) > 0) proximity.entered_by = time;
      if (impactor.record().touched(b)) continue;
      all_touched = false;
      if (!trees_[i]) trees_[i] = std::make_unique<fccda::Bvh>(impactor.surface());
      const double radius = contact_ratio * bodies[b].particles.spacing();
      const double distance = nearest_distance(*trees_[i], impactor.body().pose(), bodies[b].particles, proximity.nearest + radius) - radius;
      // of distances equal up to rounding, the first is kept
      if (std::isinf(proximity.nearest) || distance < proximity.nearest - 1e-9 * std::fabs(proximity.nearest))
        proximity.nearest = distance, proximity.nearest_time = time;
    }
    if (all_touched) trees_[i].reset();
  }
}

std::vector<std::string> ProximityMonitor::warnings(std::span<const Body> bodies, std::span<const Impactor> impactors) const {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < of_impactor_.size(); ++i)
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const Proximity& proximity = of_impactor_[i][b];
      const std::string &impactor = impactors[i].name(), &body = bodies[b].name;
      if (!impactors[i].record().touched(b))
        warnings.push_back(
            fmt::format("Impactor {} had no contact with body {} until t = {:.4g} s: the smallest distance was {:.3g} m, at t = {:.4g} s. Check position, "
                        "velocity, units and contact bounds{}, or run longer.",
                        impactor, body, time_, std::max(proximity.nearest, 0.0), proximity.nearest_time,
                        impactors[i].surface().is_closed() ? "" : "; also check the outer side of its open surface (orientation: normals or reversed)"));
      if (proximity.entered_by)
        warnings.push_back(
            fmt::format("{} particles of body {} penetrated impactor {} outside the contact bounds, the first by t = {:.4g} s, and had no contact. {}",
                        impactors[i].entered_inside(b), body, impactor, *proximity.entered_by,
                        impactors[i].surface().is_closed() ? fmt::format("Enlarge impactors.{}.contact_bounds.", impactor)
                                                           : fmt::format("They passed the boundary edge of its open surface, or impactors.{}.contact_bounds; "
                                                                         "extend them, or, if its normals point to the wrong side, set orientation.",
                                                                         impactor)));
      if (const UnresolvedPenetration& unresolved = impactors[i].unresolved(b); unresolved.count > 0)
        warnings.push_back(
            fmt::format("Particles of body {} were pinched between impactor {} and others, first at t = {:.4g} s: summed over steps, {} penetrations remained, "
                        "because no position outside all impactors was found. Forces on impactors are unreliable where they close in on a body by more than it "
                        "can deform; check their motions, or keep them at least two spacings apart.",
                        body, impactor, unresolved.first, unresolved.count));
    }
  return warnings;
}

}  // namespace perimpact
