/// Correspondence material in the deck model.
#pragma once

#include "perimpact/materials/elastic/setup.hpp"

namespace perimpact {

inline constexpr std::string_view stress_law_words[] = {"hencky", "st-venant-kirchhoff"};  // as perimpact::StressLaw

inline constexpr std::string_view stabilisation_words[] = {"bond-level", "wan", "silling"};  // as perimpact::Stabilisation

/// Correspondence (non-ordinary state-based) material: a classical stress law on the deformation gradient (docs/theory/correspondence.md).
struct CorrespondenceSetup : ElasticSetup {
  static constexpr std::string_view name = "correspondence";
  Choice law{stress_law_words};
  Choice stabilisation{stabilisation_words};
  double stabilisation_factor = 1;
  Choice influence{influence_words, 1};
  static std::span<const Field<CorrespondenceSetup>> fields();
  void check(DeckContext& deck);
};

}  // namespace perimpact
