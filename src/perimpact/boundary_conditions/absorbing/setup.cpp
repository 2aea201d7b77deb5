#include "perimpact/boundary_conditions/absorbing/setup.hpp"

#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<AbsorbingSetup>> AbsorbingSetup::fields() {
  using S = AbsorbingSetup;
  static const Field<S> all[] = {{"particle_set",
                                  &S::particle_set,
                                  "",
                                  {},
                                  required,
                                  "Name of a particle set of the body: the absorbing layer, from its inner side to the end of the body."},
                                 {"face",
                                  &S::face,
                                  "",
                                  {},
                                  required,
                                  "Outward normal of the end of the body: +x, -x, +y, -y, +z or -z. The damping increases with the square of the depth in the "
                                  "layer, from 0 at its inner side."},
                                 {"reflection", &S::reflection, "1", strictly_between(0, 1), optional,
                                  "Reflection coefficient: amplitude left of a wave at normal incidence after it has crossed the layer inward and outward. A "
                                  "thicker layer permits a smaller value; see docs/theory/boundary_conditions.md."}};
  return all;
}

void AbsorbingSetup::check(BodyContext& deck) {
  refuse_face_along_z(face, deck);
  if (deck.is_quasi_static) deck.refuse("absorbing damps waves, but relax computes equilibrium states without motion; remove one of the two.");
}

}  // namespace perimpact
