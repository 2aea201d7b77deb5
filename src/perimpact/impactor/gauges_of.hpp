/// Builds the gauges of a Setup.
#pragma once

#include <string>
#include <vector>

#include "fccda/respond/gauge.hpp"
#include "fccda/rigid_body/rigid_body.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

struct NamedGauge {
  std::string name;  ///< "propeller.blade_1", prefix of its columns
  fccda::Gauge gauge;
};

/// Throws SetupError if a gauge names an unknown part of the surface, or a zero axis.
std::vector<NamedGauge> gauges_of(const ImpactorSetup& setup, const fccda::Surface& surface, const fccda::RigidBody& body);

}  // namespace perimpact
