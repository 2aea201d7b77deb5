#include "perimpact/deck_model/boundary_conditions.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

namespace {

constexpr std::string_view particle_set_sentence = "Name of one of the body's regions. Where absent, the whole body.";
constexpr std::string_view load_times_sentence = "Times of the factors, increasing.";
constexpr std::string_view load_factors_sentence =
    "What the load is multiplied by at each time, on straight lines between; the first holds before, the last after. Where absent, 1.";

}  // namespace

std::span<const Field<FixedSetup>> FixedSetup::fields() {
  using S = FixedSetup;
  static const Field<S> all[] = {
      {"particle_set", &S::particle_set, "", {}, optional, particle_set_sentence},
      {"directions", &S::directions, "", {}, optional, "Directions in which the particles keep their undeformed place, of x, y, z. Where absent, all."}};
  return all;
}

std::span<const Field<DisplacementSetup>> DisplacementSetup::fields() {
  using S = DisplacementSetup;
  static const Field<S> all[] = {
      {"velocity", &S::velocity, "m/s", any_number(), optional, "The same velocity at all times, from t = 0 on."},
      {"displacement", &S::displacement, "m", any_number(), optional, "The same displacement at all times, from t = 0 on."},
      {"times", &S::times, "s", any_number(), optional, "Times of the points, increasing. Values between them follow a straight line."},
      {"velocities", &S::velocities, "m/s", any_number(), optional,
       "Velocity at each time; at t = 0 the particles are at their undeformed place. Before the first time the first one holds, after the last time the last "
       "one."},
      {"displacements", &S::displacements, "m", any_number(), optional,
       "In place of velocities: displacement from the undeformed place at each time. Before the first time the first one holds, after the last time the last "
       "one."},
      {"file",
       &S::file,
       "",
       {},
       optional,
       "In place of the lists: a CSV file with two columns and a first line that names them with units, \"time [s], velocity [m/s]\" or \"time [s], "
       "displacement [m]\"; a relative path starts at the deck's folder."}};
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
                                  "Force on each cubic metre along the axes of the world; weight is density times -9.81 m/s2."},
                                 {"times", &S::times, "s", any_number(), optional, load_times_sentence},
                                 {"factors", &S::factors, "1", any_number(), optional, load_factors_sentence}};
  return all;
}

std::span<const Field<PressureSetup>> PressureSetup::fields() {
  using S = PressureSetup;
  static const Field<S> all[] = {
      {"particle_set", &S::particle_set, "", {}, optional, particle_set_sentence},
      {"face", &S::face, "", {}, required, "Which way the face looks: +x, -x, +y, -y, +z or -z. Pressed are the outermost particles that way in each row."},
      {"value", &S::value, "Pa", any_number(), required, "Pressure, which pushes against that direction; a negative one pulls. It keeps its direction."},
      {"area", &S::area, "m2", positive(), optional,
       "Area of the face: the resultant is pressure times this. Where absent, that of the cells of a lattice; a cloud of points needs it."},
      {"times", &S::times, "s", any_number(), optional, load_times_sentence},
      {"factors", &S::factors, "1", any_number(), optional, load_factors_sentence}};
  return all;
}

std::span<const Field<FloatingSetup>> FloatingSetup::fields() {
  using S = FloatingSetup;
  static const Field<S> all[] = {
      {"particle_set", &S::particle_set, "", {}, optional, particle_set_sentence},
      {"level", &S::level, "m", any_number(), optional,
       "Height z of the water's surface. Where absent, the one at which the particles float as they are placed; run.json says it."},
      {"density", &S::density, "kg/m3", positive(), optional, "Density of the water."},
      {"gravity", &S::gravity, "m/s2", positive(), optional, "Gravity, along -z. It gives the particles their weight, too."},
      {"drag", &S::drag, "1", at_least(0), optional,
       "Drag coefficient C_d of particles under water at the body's surface, on the area of one face of a cube of their volume."},
      {"added_mass", &S::added_mass, "1", at_least(0), optional,
       "Mass of the water that comes along with a particle's vertical motion, in masses of the water that it displaces."},
      {"damping", &S::damping, "1/s", at_least(0), optional, "Damping of all velocities v: the force -ρ damping v, in air as in water."}};
  return all;
}

std::span<const Field<AbsorbingSetup>> AbsorbingSetup::fields() {
  using S = AbsorbingSetup;
  static const Field<S> all[] = {
      {"particle_set", &S::particle_set, "", {}, required, "Name of one of the body's regions: the layer, from its inner side to where the body ends."},
      {"face",
       &S::face,
       "",
       {},
       required,
       "Where the body ends: +x, -x, +y, -y, +z or -z. The damping rises from 0 at the inner side as the square of the depth."},
      {"reflection", &S::reflection, "1", strictly_between(0, 1), optional,
       "Share of the amplitude of a wave, straight in and out again, that is left. A thick layer can have a small one; see "
       "docs/theory/boundary_conditions.md."}};
  return all;
}

}  // namespace perimpact
