/// Builds the short-range force of a deck between its bodies.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/body/body.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/self_contact/short_range.hpp"

namespace perimpact {

/// `bodies`: built from setup.bodies, in the same order.
std::vector<ContactingBody> contacting_bodies(const Setup& setup, std::span<Body> bodies);

/// Empty if contact.fragments.law is none. Throws SetupError if 2-D bodies do not lie in one plane or are mixed with 3-D ones.
std::optional<ShortRange> short_range_of(const Setup& setup, std::span<Body> bodies);

/// Warning about initial overlap of contact distances.
std::string warning_of_overlap(const ShortRange& fragments);

}  // namespace perimpact
