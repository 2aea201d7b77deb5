/// How much memory a set-up takes, known before any of it is taken: the system grants more than it has, and ends the program, without
/// a word, when that is used.
#pragma once

#include <span>

#include "perimpact/setup/setup.hpp"
#include "perimpact/solid/discretise.hpp"

namespace perimpact {

double physical_memory();  ///< [bytes] of this machine

/// [bytes] of the arrays of all bodies and of what the impactors remember of their particles; surfaces are not counted. `bodies`: what each is cut
/// into; of the bonds of a cloud, as many as a lattice of its mean spacing has.
double memory_of(const Setup& setup, std::span<const Discretisation> bodies);

/// Throws SetupError, with the key of the largest body, where that is more than `available` [bytes].
void expect_to_fit(const Setup& setup, std::span<const Discretisation> bodies, double available);

}  // namespace perimpact
