/// Ordinary state-based material in the deck model.
#pragma once

#include "perimpact/materials/elastic/setup.hpp"

namespace perimpact {

/// Ordinary state-based material, linear and isotropic, after Madenci and Oterkus (docs/theory/ordinary_state.md).
struct OrdinaryStateSetup : ElasticSetup {
  static constexpr std::string_view name = "ordinary-state";
  static constexpr bool may_yield = true;
  static std::span<const Field<OrdinaryStateSetup>> fields();
};

}  // namespace perimpact
