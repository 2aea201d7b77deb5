/// The gauges that a Setup asks for.
#pragma once

#include <string>
#include <vector>

#include "fccda/respond/gauge.hpp"
#include "fccda/rigid_body/rigid_body.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

struct NamedGauge {
  std::string name;  ///< "propeller.blade_1", as its columns begin
  fccda::Gauge gauge;
};

/// Throws SetupError where a gauge names a part that the surface has not, or an axis without a direction.
std::vector<NamedGauge> gauges_of(const ImpactorSetup& setup, const fccda::Surface& surface, const fccda::RigidBody& body);

}  // namespace perimpact
