/// Discretisation of a body before its particles are created.
#pragma once

#include <variant>

#include "perimpact/discretisation/body_solid.hpp"
#include "perimpact/discretisation/cloud_of.hpp"
#include "perimpact/discretisation/filling.hpp"

namespace perimpact {

/// A solid to be filled with a lattice, or a point cloud.
using Discretisation = std::variant<BodySolid, Cloud>;

/// Throws SetupError for an invalid file.
inline Discretisation discretise(const BodySetup& body) {
  if (is_cloud(body)) return cloud_of(body);
  return BodySolid(body);
}

/// Number of particle slots; a double, since it may exceed the integer range.
inline double slots_of(const BodySetup& body, const Discretisation& discretisation) {
  if (const auto* cloud = std::get_if<Cloud>(&discretisation)) return static_cast<double>(cloud->points.size());
  return slots_of(body, std::get<BodySolid>(discretisation));
}

/// Number of particles (filling.hpp).
inline double particles_of(const BodySetup& body, const Discretisation& discretisation) {
  if (const auto* cloud = std::get_if<Cloud>(&discretisation)) return static_cast<double>(cloud->points.size());
  return particles_of(body, std::get<BodySolid>(discretisation));
}

}  // namespace perimpact
