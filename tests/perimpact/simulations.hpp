/// What tests of whole simulations share: running one to its end, reading its latest row of history, and what it refuses.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace fixtures {

using namespace perimpact;

inline void run(Simulation& simulation) {
  while (!simulation.clock().is_finished()) simulation.step();
}

/// The value in the latest row of history; `column` as in history.csv.
inline double value(const Simulation& simulation, const std::string& column) {
  const auto& columns = simulation.monitors().columns();
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const Column& one) { return one.heading() == column; });
  REQUIRE_MESSAGE(found != columns.end(), column);
  return simulation.monitors().row()[static_cast<std::size_t>(found - columns.begin())];
}

/// The sentence with which a setup is refused, and its key; empty where it is not.
inline std::string complaint(const Setup& setup, std::string& key) {
  try {
    Simulation simulation(setup);
  } catch (const SetupError& error) {
    key = error.key();
    return error.what();
  }
  return "";
}

/// The same in one line, "key: sentence".
inline std::string complaint(const Setup& setup) {
  std::string key;
  const std::string sentence = complaint(setup, key);
  return sentence.empty() ? "" : key + ": " + sentence;
}

}  // namespace fixtures
