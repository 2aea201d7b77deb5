/// Linear peridynamic solid in the deck model.
#pragma once

#include "perimpact/materials/elastic/setup.hpp"

namespace perimpact {

/// Linear peridynamic solid after Silling et al.: ordinary state-based, normalised by each particle's own weighted volume.
struct LinearSolidSetup : ElasticSetup {
  static constexpr std::string_view name = "linear-peridynamic-solid";
  Choice influence{influence_words, 1};
  static std::span<const Field<LinearSolidSetup>> fields();
  void check(BodyContext& deck);
};

}  // namespace perimpact
