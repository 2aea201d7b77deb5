/// How much memory a set-up takes, known before any of it is taken: the system grants more than it has, and ends the program, without
/// a word, when that is used.
#pragma once

#include "perimpact/setup/setup.hpp"

namespace perimpact {

double physical_memory();  ///< [bytes] of this machine

/// [bytes] of the arrays of all bodies and of what the impactors remember of their particles; surfaces are not counted.
double memory_of(const Setup& setup);

/// Throws SetupError, with the key of the largest body, where that is more than `available` [bytes].
void expect_to_fit(const Setup& setup, double available);

}  // namespace perimpact
