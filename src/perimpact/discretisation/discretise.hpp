/// What a body is cut into, before any particle is made.
#pragma once

#include <variant>

#include "perimpact/discretisation/body_solid.hpp"
#include "perimpact/discretisation/cloud_of.hpp"
#include "perimpact/discretisation/filling.hpp"

namespace perimpact {

/// A solid that a lattice will fill, or a cloud.
using Discretisation = std::variant<BodySolid, Cloud>;

/// Throws SetupError where a file cannot be used.
inline Discretisation discretise(const BodySetup& body) {
  if (is_cloud(body)) return cloud_of(body);
  return BodySolid(body);
}

/// Length of the arrays of its particles. A double, for there may be too many to count.
inline double slots_of(const BodySetup& body, const Discretisation& discretisation) {
  if (const auto* cloud = std::get_if<Cloud>(&discretisation)) return static_cast<double>(cloud->points.size());
  return slots_of(body, std::get<BodySolid>(discretisation));
}

}  // namespace perimpact
