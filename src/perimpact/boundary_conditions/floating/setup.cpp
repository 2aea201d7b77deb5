#include "perimpact/boundary_conditions/floating/setup.hpp"

#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<FloatingSetup>> FloatingSetup::fields() {
  using S = FloatingSetup;
  static const Field<S> all[] = {
      {"particle_set", &S::particle_set, "", {}, optional, particle_set_sentence},
      {"level", &S::level, "m", any_number(), optional,
       "Height z of the free water surface. Where absent, the level at which the particles float in their initial position, reported in run.json."},
      {"density", &S::density, "kg/m3", positive(), optional, "Density of the water."},
      {"gravity", &S::gravity, "m/s2", positive(), optional, "Acceleration of gravity, along -z; it also gives the particles their weight."},
      {"drag", &S::drag, "1", at_least(0), optional,
       "Drag coefficient C_d of submerged particles at the body's surface, referred to one face of a cube of the particle's volume."},
      {"added_mass", &S::added_mass, "1", at_least(0), optional,
       "Added-mass coefficient for vertical motion: entrained mass over the mass of water that the particle displaces."},
      {"entrained_depth", &S::entrained_depth, "m", at_least(0), optional,
       "In place of added_mass: depth d of the water that moves vertically with each wet column of particles, whose mass per unit area is density d. A plate "
       "that bends with the wavenumber k entrains 1/k, a heaving patch of radius R 2R/π; perimpact check reports the characteristic length of a sheet."},
      {"dry_top", &S::dry_top, "m", at_least(0), optional,
       "Depth below the water level down to which the top of a column stays dry while no bond of its particles is broken: its buoyancy increases until there. "
       "Deeper, or broken, it is flooded for good. 0 floods every top at the level."},
      {"damping", &S::damping, "1/s", at_least(0), optional, "Mass-proportional damping of all velocities v: force density -ρ damping v, in air as in water."}};
  return all;
}

void FloatingSetup::check(BodyContext& deck) {
  refuse_along_z("gravity", deck);
  if (added_mass > 0 && entrained_depth > 0)
    deck.refuse("entrained_depth", "entrained_depth is given beside added_mass, and both are the water that moves with the body; remove one of the two.");
}

}  // namespace perimpact
