#include "perimpact/boundary_conditions/pressure/setup.hpp"

#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<PressureSetup>> PressureSetup::fields() {
  using S = PressureSetup;
  static const Field<S> all[] = {
      {"particle_set", &S::particle_set, "", {}, optional, particle_set_sentence},
      {"face",
       &S::face,
       "",
       {},
       required,
       "Outward normal of the loaded face: +x, -x, +y, -y, +z or -z. The pressure acts on the outermost particle of each row in that direction."},
      {"value", &S::value, "Pa", any_number(), required,
       "Pressure, acting against the outward normal; a negative value pulls. Its direction is fixed and does not follow the deformation."},
      {"area", &S::area, "m2", positive(), optional,
       "Area of the face: the resultant is pressure times area. Where absent, the area of the lattice cells on the face; required for a point cloud."},
      {"times", &S::times, "s", any_number(), optional, load_times_sentence},
      {"factors", &S::factors, "1", any_number(), optional, load_factors_sentence}};
  return all;
}

void PressureSetup::check(BodyContext& deck) {
  if (value == 0) deck.refuse("value", "value is 0, which has no effect; give a value, or remove the boundary condition.");
  refuse_face_along_z(face, deck);
  check_factors(times, factors, deck);
}

}  // namespace perimpact
