/// Step and duration of a run whose bodies are too large to be built for the question: both are those of blocks of the same materials.
#pragma once

#include <span>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/discretise.hpp"

namespace perimpact {

struct Forecast {
  double step;     ///< [s] time step
  double steps;    ///< number of steps
  double set_up;   ///< [s] wall-clock time, by particles
  double running;  ///< [s] wall-clock time of all steps, by particles; without impactors
};

/// Builds a block of each body (sample_block.hpp), apart from each other, and performs a few steps of the dynamic run. `bodies`: discretisation of each;
/// `particles`: of all. Throws SetupError as Simulation.
Forecast forecast_of(const Setup& setup, std::span<const Discretisation> bodies, double particles);

}  // namespace perimpact
