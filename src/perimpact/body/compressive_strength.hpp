/// Uniaxial compressive strength that a body's material and failure criterion imply (docs/theory/damage.md, docs/theory/ice_plasticity.md).
///
///   plasticity                    σ_c of its yield surface
///   compression: symmetric        E s_c
///   compression: limit            E times critical_compression
///   none of these                 bonds across the load break, E s_c/(ν - α)
#pragma once

#include <optional>

#include "perimpact/body/body.hpp"

namespace perimpact {

struct CompressiveStrength {
  double uniform;               ///< [Pa] where strain is uniform; infinite if nothing fails
  std::optional<double> faces;  ///< [Pa] of a specimen with free faces, as measured on lattices; infinite if nothing fails; absent if not measured
};

/// Empty if nothing of the body can fail or yield.
std::optional<CompressiveStrength> compressive_strength(const BodySetup& setup, const Body& body);

}  // namespace perimpact
