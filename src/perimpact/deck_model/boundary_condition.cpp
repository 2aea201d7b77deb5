#include "perimpact/deck_model/boundary_condition.hpp"

#include <fmt/format.h>

#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

void refuse_along_z(std::string_view key, const BodyContext& deck) {
  if (!deck.body.is_plane()) return;
  deck.refuse(key, fmt::format("{} acts along z, but body {} is 2-D and its particles stay in the plane; remove it.", key, deck.body.name));
}

void refuse_face_along_z(const Choice& face, const BodyContext& deck) {
  if (face.word().ends_with('z')) refuse_along_z("face", deck);
}

void check_factors(const std::vector<double>& times, const std::vector<double>& factors, const BodyContext& deck) {
  check_as_many(factors.size(), times.size(), "factors", deck.key + (factors.empty() ? ".times" : ".factors"));
  check_increasing(times, deck.key + ".times");
}

}  // namespace perimpact
