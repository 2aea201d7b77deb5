/// Probes of a run: points and lines of a body.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "perimpact/body/body.hpp"

namespace perimpact {

/// Probe at a point of the undeformed body, evaluated at the nearest particles: all at the same distance (to 1e-6 of the spacing), up to eight.
/// All members are collective.
class Sample {
 public:
  Sample(const Body& body, const Vec3d& point);
  Vec3d at;                                                   ///< [m] in the reference configuration
  double distance() const { return near_.front().distance; }  ///< [m] from the point to these particles
  Vec3d displacement(const Body& body) const;                 ///< [m] mean
  std::vector<std::uint32_t> slots() const;                   ///< of these particles, in a run of one rank

 private:
  static constexpr std::size_t most = 8;
  struct Near {
    std::size_t whole_slot, slot;  // on the whole lattice, and on that of its rank
    int rank;
    double distance;  // [m]
  };
  std::vector<Near> near_;
};

/// Samples at the midpoints of equal segments of a line, one per spacing.
std::vector<Sample> samples_along(const Body& body, const Vec3d& from, const Vec3d& to);

}  // namespace perimpact
