/// Warnings about a set-up, known before the first step. Sentences for the user; results are not affected.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/body/body.hpp"
#include "perimpact/discretisation/filled_mass.hpp"
#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

/// Moduli and densities in a wrong unit, breaking bodies without contact between fragments, thin bodies, discretised mass, particles without bonds, cracks
/// without effect. `masses`: of each body, where known.
std::vector<std::string> warnings_about_bodies(const Setup& setup, std::span<const Body> bodies, std::span<const std::optional<FilledMass>> masses);

/// Overlapping components, defects of surfaces, their resolution and motion relative to the bodies. `dt`: time step [s].
std::vector<std::string> warnings_about_impactors(const Setup& setup, std::span<const Body> bodies, std::span<const Impactor> impactors, double dt);

}  // namespace perimpact
