/// Regions: names for some of the particles of a body, which boundaries and failure refer to.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// The slots, ascending, of the particles whose reference position is in the region of that name; those on its surface are in it (surface_share).
/// Throws SetupError: with `key`, of what names the region, where the body has none of that name; with the region's where it holds no
/// particle, or its file cannot be used.
std::vector<std::size_t> slots_in(std::string_view region, const BodySetup& body, const Particles& particles, const std::string& key);

}  // namespace perimpact
