/// How much memory a set-up takes, known before any of it is taken: the system grants more than it has, and ends the program, without
/// a word, when that is used.
#pragma once

#include <span>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/discretise.hpp"

namespace perimpact {

double physical_memory();  ///< [bytes] of this machine

/// [bytes] What a run takes at most, counted array by array; surfaces are not counted, nor the report, which is made when the rest is free again.
struct Memory {
  double at_rest = 0;     ///< that stays from the first step on
  double setting_up = 0;  ///< the most while the bodies are made
  double pictures = 0;    ///< the most while a picture is written
  double rubble = 0;      ///< more, where `contact.fragments` is given and all bonds have broken: in rubble as dense as the solid

  double peak() const;  ///< without rubble
};

/// `bodies`: what each is cut into. The bonds of a cloud are counted for some of its particles.
Memory memory_of(const Setup& setup, std::span<const Discretisation> bodies);

/// Throws SetupError, with the key of the largest body, where the peak is more than `available` [bytes].
void expect_to_fit(const Setup& setup, std::span<const Discretisation> bodies, double available);

}  // namespace perimpact
