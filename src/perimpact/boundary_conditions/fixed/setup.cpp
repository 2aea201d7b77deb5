#include "perimpact/boundary_conditions/fixed/setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>

#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/distinct_words.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<FixedSetup>> FixedSetup::fields() {
  using S = FixedSetup;
  static const Field<S> all[] = {
      {"particle_set", &S::particle_set, "", {}, optional, particle_set_sentence},
      {"directions", &S::directions, "", {}, optional, "Directions with zero displacement (homogeneous Dirichlet condition), of x, y, z. Where absent, all."}};
  return all;
}

void FixedSetup::check(BodyContext& deck) {
  const auto refuse = [&](const std::string& sentence) { deck.refuse("directions", sentence); };
  const auto expect_known = [&](const std::string& direction) {
    if (std::find(std::begin(axis_words), std::end(axis_words), direction) == std::end(axis_words))
      refuse(fmt::format("directions contains \"{}\", which is not a direction; known are {}.", direction, fmt::join(axis_words, ", ")));
  };
  check_distinct("directions", directions, expect_known, refuse);
}

}  // namespace perimpact
