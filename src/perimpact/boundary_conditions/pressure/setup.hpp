/// Pressure in the deck model.
#pragma once

#include "perimpact/deck_model/boundary_condition.hpp"

namespace perimpact {

/// Pressure on the outermost particles of a face.
struct PressureSetup {
  static constexpr std::string_view name = "pressure";
  std::string particle_set;  ///< the whole body where empty
  Choice face{face_words};
  double value{};              ///< [Pa] positive into the body
  std::optional<double> area;  ///< [m²]; from the cells of the lattice where absent
  std::vector<double> times;   ///< [s] of `factors`; constant where empty
  std::vector<double> factors;
  static std::span<const Field<PressureSetup>> fields();
  void check(BodyContext& deck);
};

}  // namespace perimpact
