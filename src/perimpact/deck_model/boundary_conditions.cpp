#include "perimpact/deck_model/boundary_conditions.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

namespace {

constexpr std::string_view particle_set_sentence = "Name of a particle set of the body. Where absent, the whole body.";
constexpr std::string_view load_times_sentence = "Times of the factors, increasing.";
constexpr std::string_view load_factors_sentence =
    "Factor on the load at each time, interpolated linearly; constant before the first time and after the last. Where absent, 1.";

}  // namespace

std::span<const Field<FixedSetup>> FixedSetup::fields() {
  using S = FixedSetup;
  static const Field<S> all[] = {
      {"particle_set", &S::particle_set, "", {}, optional, particle_set_sentence},
      {"directions", &S::directions, "", {}, optional, "Directions with zero displacement (homogeneous Dirichlet condition), of x, y, z. Where absent, all."}};
  return all;
}

std::span<const Field<DisplacementSetup>> DisplacementSetup::fields() {
  using S = DisplacementSetup;
  static const Field<S> all[] = {
      {"velocity", &S::velocity, "m/s", any_number(), optional, "Constant velocity from t = 0 on."},
      {"displacement", &S::displacement, "m", any_number(), optional, "Constant displacement from t = 0 on."},
      {"times", &S::times, "s", any_number(), optional, table_times_sentence},
      {"velocities", &S::velocities, "m/s", any_number(), optional,
       "Velocity at each time; the displacement is zero at t = 0. Constant before the first time and after the last."},
      {"displacements", &S::displacements, "m", any_number(), optional,
       "In place of velocities: displacement from the undeformed position at each time. Constant before the first time and after the last."},
      {"file", &S::file, "", {}, optional, table_file_sentence}};
  return all;
}

std::span<const Field<PrescribedSetup>> PrescribedSetup::fields() {
  static const Field<PrescribedSetup> all[] = {{"particle_set", &PrescribedSetup::particle_set, "", {}, optional, particle_set_sentence}};
  return all;
}

std::span<const Field<BodyForceSetup>> BodyForceSetup::fields() {
  using S = BodyForceSetup;
  static const Field<S> all[] = {{"particle_set", &S::particle_set, "", {}, optional, particle_set_sentence},
                                 {"force_density", &S::force_density, "N/m3", any_number(), required,
                                  "Force per unit volume (body force density) in global axes; for weight, density times -9.81 m/s2 in z."},
                                 {"times", &S::times, "s", any_number(), optional, load_times_sentence},
                                 {"factors", &S::factors, "1", any_number(), optional, load_factors_sentence}};
  return all;
}

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
      {"damping", &S::damping, "1/s", at_least(0), optional, "Mass-proportional damping of all velocities v: force density -ρ damping v, in air as in water."}};
  return all;
}

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

}  // namespace perimpact
