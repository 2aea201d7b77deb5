#include "perimpact/diagnostics/proximity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace perimpact {

namespace {

/// The least distance of the particles' centres from the surface, where it is less than `cap` [m]; else `cap`.
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
      // of distances that are equal but for rounding the first is told
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
        warnings.push_back(fmt::format(
            "Impactor {} never touched body {} until t = {:.4g} s: the nearest it came was {:.3g} m, at t = {:.4g} s. Check position, velocity, units "
            "and region{}, or run longer.",
            impactor, body, time_, std::max(proximity.nearest, 0.0), proximity.nearest_time,
            impactors[i].surface().is_closed() ? "" : ", and which side of its open surface is outside (outside: normals or reversed)"));
      if (proximity.entered_by)
        warnings.push_back(
            fmt::format("{} particles of body {} came to be inside impactor {} where it is not felt, the first by t = {:.4g} s, and were not struck. {}",
                        impactors[i].entered_inside(b), body, impactor, *proximity.entered_by,
                        impactors[i].surface().is_closed() ? fmt::format("Enlarge impactors.{}.contact_bounds.", impactor)
                                                           : fmt::format("They came round the rim of its open surface, or past impactors.{}.contact_bounds; "
                                                                         "let it reach further, or, if its normals point to the wrong "
                                                                         "side, turn it with outside.",
                                                                         impactor)));
      if (const UnresolvedPenetration& unresolved = impactors[i].unresolved(b); unresolved.count > 0)
        warnings.push_back(fmt::format(
            "Particles of body {} were pinched between impactor {} and others, first at t = {:.4g} s: summed over steps, {} were left inside it, since "
            "no place outside of all was found. Forces on the impactors are not to be trusted where they close in on a body by more than it can give way; "
            "check their "
            "courses, or leave them apart by two spacings at least.",
            body, impactor, unresolved.first, unresolved.count));
    }
  return warnings;
}

}  // namespace perimpact
