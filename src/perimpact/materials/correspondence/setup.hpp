/// Correspondence material in the deck model.
#pragma once

#include "perimpact/materials/elastic/setup.hpp"

namespace perimpact {

inline constexpr std::string_view stress_law_words[] = {"hencky", "st-venant-kirchhoff"};
enum class StressLaw { hencky, st_venant_kirchhoff };
static_assert(fccda::are_enumerators<StressLaw>(stress_law_words));

inline constexpr std::string_view stabilisation_words[] = {"bond-level", "wan", "silling"};
enum class Stabilisation { bond_level, wan, silling };
static_assert(fccda::are_enumerators<Stabilisation>(stabilisation_words));

/// Correspondence (non-ordinary state-based) material: a classical stress law on the deformation gradient (docs/theory/correspondence.md).
struct CorrespondenceSetup : ElasticSetup {
  static constexpr std::string_view name = "correspondence";
  Choice law{stress_law_words};
  Choice stabilisation{stabilisation_words};
  double stabilisation_factor = 1;
  Choice influence{influence_words, 1};
  static std::span<const Field<CorrespondenceSetup>> fields();
  void check(BodyContext& deck);
};

}  // namespace perimpact
