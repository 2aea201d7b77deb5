#include "perimpact/deck_model/deck_context.hpp"

#include <fmt/format.h>

#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

void refuse_surface_correction(std::string_view model, const BodyContext& deck) {
  const SurfaceCorrection correction = deck.body.surface_correction.as<SurfaceCorrection>();
  if (correction != SurfaceCorrection::energy && correction != SurfaceCorrection::volume) return;
  deck.refuse_body("surface_correction",
                   fmt::format("surface_correction is {}, but the model {} needs none, since it normalises each particle by its own family; remove "
                               "surface_correction.",
                               deck.body.surface_correction.word(), model));
}

}  // namespace perimpact
