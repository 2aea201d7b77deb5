/// The short-range force that a deck asks for, between the bodies that it makes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/body/body.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/self_contact/short_range.hpp"

namespace perimpact {

/// `bodies`: made of setup.bodies, in that order.
std::vector<ContactingBody> contacting_bodies(const Setup& setup, std::span<Body> bodies);

/// Nothing where contact.fragments.law is none. Throws SetupError where bodies of two dimensions do not lie in one plane, or not all are.
std::optional<ShortRange> short_range_of(const Setup& setup, std::span<Body> bodies);

/// That particles touch before anything has moved: a sentence.
std::string warning_of_overlap(const ShortRange& fragments);

}  // namespace perimpact
