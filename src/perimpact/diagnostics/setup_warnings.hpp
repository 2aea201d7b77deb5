/// Warnings about a set-up, known before the first step. Sentences for the user; results are not affected.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/body/body.hpp"
#include "perimpact/boundary_conditions/boundary_conditions.hpp"
#include "perimpact/discretisation/filled_mass.hpp"
#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

/// Moduli, strengths and densities in a wrong unit, bodies that yield before they break in bending, breaking bodies without contact between fragments, thin
/// bodies, discretised mass, particles without bonds, cracks without effect. `masses`: of each body, where known.
std::vector<std::string> warnings_about_bodies(const Setup& setup, std::span<const Body> bodies, std::span<const std::optional<FilledMass>> masses);

/// Floating bodies at rest that are not in equilibrium. `conditions`: of each body.
std::vector<std::string> warnings_about_floating(const Setup& setup, std::span<const Body> bodies, std::span<const BoundaryConditions> conditions);

/// Overlapping components, defects of surfaces, their resolution and motion relative to the bodies. `dt`: time step [s].
std::vector<std::string> warnings_about_impactors(const Setup& setup, std::span<const Body> bodies, std::span<const Impactor> impactors, double dt);

}  // namespace perimpact
