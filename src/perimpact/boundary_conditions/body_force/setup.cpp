#include "perimpact/boundary_conditions/body_force/setup.hpp"

#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<BodyForceSetup>> BodyForceSetup::fields() {
  using S = BodyForceSetup;
  static const Field<S> all[] = {{"particle_set", &S::particle_set, "", {}, optional, particle_set_sentence},
                                 {"force_density", &S::force_density, "N/m3", any_number(), required,
                                  "Force per unit volume (body force density) in global axes; for weight, density times -9.81 m/s2 in z."},
                                 {"times", &S::times, "s", any_number(), optional, load_times_sentence},
                                 {"factors", &S::factors, "1", any_number(), optional, load_factors_sentence}};
  return all;
}

void BodyForceSetup::check(BodyContext& deck) {
  if (force_density == Vec3d{})
    deck.refuse("force_density", "force_density is [0, 0, 0], which has no effect; give a value, or remove the boundary condition.");
  if (force_density.z != 0) refuse_along_z("force_density", deck);
  check_factors(times, factors, deck);
}

}  // namespace perimpact
