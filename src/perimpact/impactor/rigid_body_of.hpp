/// Builds the rigid body of a Setup, with its motion, loads and water.
#pragma once

#include <optional>
#include <vector>

#include "fccda/rigid_body/applied_load.hpp"
#include "fccda/rigid_body/prescribed_motion.hpp"
#include "fccda/rigid_body/rigid_body.hpp"
#include "marine/still_water.hpp"
#include "mesh/surface.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

/// Throws SetupError if mass or inertia is undefined or insufficient. With prescribed motion, the body starts at its velocity.
fccda::RigidBody rigid_body_of(const ImpactorSetup& setup, const fccda::Surface& surface, const fccda::PrescribedMotion& motion);

/// Throw SetupError for an invalid table.
fccda::PrescribedMotion motion_of(const ImpactorSetup& setup);
std::vector<fccda::AppliedLoad> loads_of(const ImpactorSetup& setup);

/// The water, if the impactor floats.
std::optional<fccda::StillWater> water_of(const ImpactorSetup& setup);

/// True if the mass, the centre of mass, or the inertia of a free rotation follows from the enclosed volume.
bool is_weighed_by_volume(const ImpactorSetup& setup);

}  // namespace perimpact
