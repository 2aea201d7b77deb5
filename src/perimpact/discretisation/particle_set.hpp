/// Particle sets: named subsets of a body's particles, for boundary conditions and failure.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Slots, ascending, of the particles whose reference position is in the named set, surface included (surface_share). Throws SetupError: with
/// `key`, of the reference to the set, if the body has no such set; with the key of the set if it is empty or its file is invalid.
std::vector<std::size_t> slots_in(std::string_view region, const BodySetup& body, const Particles& particles, const std::string& key);

}  // namespace perimpact
