/// What a body carries in tension, bending and compression as text, for `check`.
#pragma once

#include <string>

#include "perimpact/body/body.hpp"

namespace perimpact {

/// Empty for a body that neither fails nor yields.
std::string strength_text(const BodySetup& setup, const Body& body);

}  // namespace perimpact
