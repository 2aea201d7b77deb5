/// Probes of a run: points and lines of a body.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "perimpact/body/body.hpp"

namespace perimpact {

/// Probe at a point of the undeformed body, evaluated at the nearest particles: all at the same distance (to 1e-6 of the spacing), up to eight.
struct Sample {
  Vec3d at;  ///< [m] in the reference configuration
  std::vector<std::uint32_t> slots;

  Sample(const Body& body, const Vec3d& point);
  double distance(const Body& body) const;     ///< [m] from the point to these particles
  Vec3d displacement(const Body& body) const;  ///< [m] mean
};

/// Samples at the midpoints of equal segments of a line, one per spacing.
std::vector<Sample> samples_along(const Body& body, const Vec3d& from, const Vec3d& to);

}  // namespace perimpact
