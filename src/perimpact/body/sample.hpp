/// Where a run is looked at: points and lines of a body.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "perimpact/body/body.hpp"

namespace perimpact {

/// A point of the undeformed body, seen through the particles nearest to it: all that are equally near (to 1e-6 of the spacing), up to eight.
struct Sample {
  Vec3d at;  ///< [m] in the reference configuration
  std::vector<std::uint32_t> slots;

  Sample(const Body& body, const Vec3d& point);
  double distance(const Body& body) const;     ///< [m] from the point to these particles
  Vec3d displacement(const Body& body) const;  ///< [m] mean
};

/// Samples at the middles of equal pieces of a line, as many as spacings fit.
std::vector<Sample> samples_along(const Body& body, const Vec3d& from, const Vec3d& to);

}  // namespace perimpact
