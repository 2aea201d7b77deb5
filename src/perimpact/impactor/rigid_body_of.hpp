/// The rigid body that a Setup asks for, and what moves it besides contact.
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

/// Throws SetupError where mass and inertia cannot be had or do not suffice. Where a motion is prescribed, the body starts with its velocity.
fccda::RigidBody rigid_body_of(const ImpactorSetup& setup, const fccda::Surface& surface, const fccda::PrescribedMotion& motion);

/// Throw SetupError where a table cannot be used.
fccda::PrescribedMotion motion_of(const ImpactorSetup& setup);
std::vector<fccda::AppliedLoad> loads_of(const ImpactorSetup& setup);

/// The water that it floats in, where it does.
std::optional<fccda::StillWater> water_of(const ImpactorSetup& setup);

/// True where the mass, the centre of mass, or the inertia that a free rotation needs, comes from the volume inside the surface.
bool is_weighed_by_volume(const ImpactorSetup& setup);

}  // namespace perimpact
