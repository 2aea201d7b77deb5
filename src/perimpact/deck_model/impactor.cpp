// The tables of the impactors: surfaces, contact bounds, remeshing, gauges, motion and loads.
#include "perimpact/deck_model/setup.hpp"

#include <numbers>
#include <utility>

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<CylinderSurface>> CylinderSurface::fields() {
  using S = CylinderSurface;
  static const Field<S> all[] = {{"diameter", &S::diameter, "m", positive(), required, "Diameter."},
                                 {"height", &S::height, "m", positive(), required, "Length along the axis, centred on the origin."},
                                 {"axis", &S::axis, "", {}, optional, "Direction of the axis: x, y or z."},
                                 {"edge_length", &S::edge_length, "m", positive(), required,
                                  "Longest panel edge around, along and between the rings of the caps; diagonals of triangles reach 1.41 times it."},
                                 {"panel_shape", &S::panel_shape, "", {}, optional, "triangles or quads."}};
  return all;
}

std::span<const Field<SphereSurface>> SphereSurface::fields() {
  using S = SphereSurface;
  static const Field<S> all[] = {{"diameter", &S::diameter, "m", positive(), required, "Diameter."},
                                 {"edge_length", &S::edge_length, "m", positive(), required, "Longest panel edge."}};
  return all;
}

std::span<const Field<BoxSurface>> BoxSurface::fields() {
  using S = BoxSurface;
  static const Field<S> all[] = {
      {"size", &S::size, "m", positive(), required, "Edge lengths in x, y and z, centred on the origin."},
      {"edge_length", &S::edge_length, "m", positive(), required, "Longest panel edge along x, y and z; diagonals of triangles reach 1.41 times it."},
      {"panel_shape", &S::panel_shape, "", {}, optional, "triangles or quads."}};
  return all;
}

std::span<const Field<FileSurface>> FileSurface::fields() {
  using S = FileSurface;
  constexpr double full_turn = 6.2832;  // [rad] plus a margin for rounding; rejects 90 without its unit
  static const Field<S> all[] = {
      {"file",
       &S::file,
       "",
       {},
       required,
       "Mesh file: STL, OBJ, PLY, OFF, VTK, VTP, VTU, MSH (Gmsh), INP (Abaqus), K, KEY or DYN (LS-DYNA), each also compressed as .gz; STEP and IGES if gmsh is "
       "installed. A relative path starts at the deck's folder."},
      {"file_parts", &S::file_parts, "", {}, optional, "Names of the parts of the file to read; all where absent. `perimpact mesh` lists them."},
      {"scale", &S::scale, "1", positive(), optional, "Factor that converts the coordinates to metres: 0.001 for a file in millimetres."},
      {"mirror", &S::mirror, "", {}, optional, "Mirrors the surface in the plane x = 0, y = 0 or z = 0; left becomes right."},
      {"mirror_merge",
       &S::mirror_merge,
       "",
       {},
       optional,
       "Adds the mirror image in the plane x = 0, y = 0 or z = 0: y for a file that contains half of a ship. Panels in that plane are removed."},
      {"rotate", &S::rotate, "rad", between(-full_turn, full_turn), optional,
       "Rotates the surface about the axes x, y and z through the origin, in this order: [90 deg, 0, 0]."},
      {"translate", &S::translate, "m", any_number(), optional,
       "Translates the surface. Scale, mirror, mirror_merge, rotate and translate apply in this order."},
      {"weld", &S::weld, "m", positive(), optional,
       "Welding tolerance: vertices closer than this are merged, which closes rounding gaps between panels. Where absent, 1e-9 of the surface's size. "
       "`perimpact mesh` reports the tolerance that would close a surface."},
      {"orientation",
       &S::orientation,
       "",
       {},
       optional,
       "Outer side of an open surface: normals (the side to which the panel normals point) or reversed. Closed surfaces are oriented automatically."}};
  return all;
}

std::span<const Field<ContactBoundsSetup>> ContactBoundsSetup::fields() {
  static const Field<ContactBoundsSetup> all[] = {
      {"on_exceed",
       &ContactBoundsSetup::on_exceed,
       "",
       {},
       optional,
       "Action if a panel lies outside the contact bounds: error, or clip (contact is ignored outside the bounds)."}};
  return all;
}

std::span<const Field<RefinementSetup>> RefinementSetup::fields() {
  using S = RefinementSetup;
  static const Field<S> all[] = {
      {"edge_length", &S::edge_length, "m", positive(), required, "Longest panel edge after refinement. Panels are bisected until none is longer."},
      {"surface_part", &S::surface_part, "", {}, optional, "Restricts refinement to this part of the surface. Where absent, all parts."},
      {"angle", &S::angle, "rad", strictly_between(0, std::numbers::pi), optional,
       "Restricts refinement to curved areas: panels are refined until they turn by at most this angle, for example 10 deg, but not below edge_length; creases "
       "are refined to edge_length. Where absent, flat areas are refined too."}};
  return all;
}

std::span<const Field<CoarseningSetup>> CoarseningSetup::fields() {
  using S = CoarseningSetup;
  static const Field<S> all[] = {
      {"max_deviation", &S::max_deviation, "m", positive(), required,
       "Maximum deviation of the surface from its original shape. Exactly flat areas need next to nothing."},
      {"max_edge_length", &S::max_edge_length, "m", positive(), optional, "Longest edge that coarsening may create. Where absent, no limit."}};
  return all;
}

std::span<const Field<GaugeSetup>> GaugeSetup::fields() {
  using S = GaugeSetup;
  static const Field<S> all[] = {
      {"surface_parts", &S::surface_parts, "", {}, optional, "Names of parts of the surface (`perimpact mesh` lists them). Where absent, the whole surface."},
      {"point", &S::point, "m", any_number(), optional,
       "Reference point of the moments, relative to the surface's origin and in its axes; it moves with the impactor. Where absent, the centre of mass."},
      {"axis", &S::axis, "1", any_number(), optional,
       "Direction in the surface's axes, rotating with them, about which the torque is also reported. Its length is irrelevant."}};
  return all;
}

std::span<const Field<TranslationTable>> TranslationTable::fields() {
  using S = TranslationTable;
  static const Field<S> all[] = {
      {"times", &S::times, "s", any_number(), optional, table_times_sentence},
      {"velocities", &S::velocities, "m/s", any_number(), optional, "Velocity at each time; constant before the first time and after the last."},
      {"displacements", &S::displacements, "m", any_number(), optional,
       "In place of velocities: displacement at each time. Only differences matter: at t = 0 the impactor is at its position. It is at rest before the first "
       "time and after the last."},
      {"file", &S::file, "", {}, optional, table_file_sentence}};
  return all;
}

std::span<const Field<RotationTable>> RotationTable::fields() {
  using S = RotationTable;
  static const Field<S> all[] = {
      {"times", &S::times, "s", any_number(), optional, table_times_sentence},
      {"velocities", &S::velocities, "rad/s", any_number(), optional, "Angular velocity at each time; constant before the first time and after the last."},
      {"displacements", &S::displacements, "rad", any_number(), optional,
       "In place of velocities: angle at each time, for the only axis about which the impactor rotates. Only differences matter. It is at rest before the "
       "first time and after the last."},
      {"file",
       &S::file,
       "",
       {},
       optional,
       "In place of the lists: a CSV file with two columns and a header line with units, \"time [s], velocity [rad/s]\" or \"time [s], displacement [rad]\"; a "
       "relative path starts at the deck's folder."}};
  return all;
}

const MotionTable* MotionSetup::of(std::size_t degree) const {
  const auto table = [](const auto& one) -> const MotionTable* { return one ? &*one : nullptr; };
  const MotionTable* const tables[] = {table(x), table(y), table(z), table(rx), table(ry), table(rz)};
  return tables[degree];
}

MotionTable* MotionSetup::of(std::size_t degree) { return const_cast<MotionTable*>(std::as_const(*this).of(degree)); }

std::span<const Field<LoadSetup>> LoadSetup::fields() {
  using S = LoadSetup;
  static const Field<S> all[] = {
      {"force", &S::force, "N", any_number(), optional, "Force in global axes."},
      {"moment", &S::moment, "N m", any_number(), optional, "Moment in global axes, in addition to that of the force."},
      {"point", &S::point, "m", any_number(), optional,
       "Point of application of the force, relative to the surface's origin and in its axes; it moves with the impactor. Where absent, the centre of mass."},
      {"times", &S::times, "s", any_number(), optional, "Times of the factors, increasing."},
      {"factors", &S::factors, "1", any_number(), optional,
       "Factor on force and moment at each time, interpolated linearly; constant before the first time and after the last. Where absent, 1."},
      {"speeds", &S::speeds, "m/s", any_number(), optional, "Speeds of the speed factors, increasing: velocity of the centre of mass along the force."},
      {"speed_factors", &S::speed_factors, "1", any_number(), optional,
       "Further factor on force and moment at each speed, interpolated linearly; constant below the first speed and above the last. Where absent, 1."}};
  return all;
}

std::span<const Field<FloatingImpactorSetup>> FloatingImpactorSetup::fields() {
  using S = FloatingImpactorSetup;
  static const Field<S> all[] = {
      {"level", &S::level, "m", any_number(), optional, "Height z of the free water surface."},
      {"density", &S::density, "kg/m3", positive(), optional, "Density of the water."},
      {"gravity", &S::gravity, "m/s2", positive(), optional, "Acceleration of gravity, along -z."},
      {"added_mass", &S::added_mass, "1", at_least(0), optional,
       "Added mass for vertical motion, as a share of the mass of water that the impactor displaces at rest; for an impactor heavier than water, of all that "
       "its surface encloses."},
      {"damping", &S::damping, "1/s", at_least(0), optional, "Decay rate of v_z, ω_x and ω_y (heave, roll and pitch) while in the water."}};
  return all;
}

std::span<const Field<ElasticImpactorSetup>> ElasticImpactorSetup::fields() {
  using S = ElasticImpactorSetup;
  static const Field<S> all[] = {
      {"modes",
       &S::modes,
       "",
       {},
       required,
       "File of vibration modes on the vertices of the surface, in its axes and in metres: VTU, VTP, VTK or CSV, each also compressed as .gz. A relative path "
       "starts at the deck's folder. `python3 -m perimpact.modes` writes it from the results of a finite-element program."},
      {"damping", &S::damping, "1", Range{.low = 0, .high = 1, .high_included = false}, optional,
       "Damping of every mode as a ratio of critical damping. Where absent, that of the file; 0 where it has none."},
      {"highest_frequency", &S::highest_frequency, "Hz", positive(), optional, "Modes of higher frequency are left out. Where absent, none."}};
  return all;
}

std::span<const Field<ImpactorSetup>> ImpactorSetup::fields() {
  using S = ImpactorSetup;
  static const Field<S> all[] = {
      {"mass", &S::mass, "kg", positive(), optional, "Mass; alternatively, give the density."},
      {"density", &S::density, "kg/m3", positive(), optional,
       "In place of the mass: density of a body that fills the closed surface uniformly. Overlapping parts of a surface count twice."},
      {"centre_of_mass", &S::centre_of_mass, "m", any_number(), optional,
       "Centre of mass, relative to the surface's origin and in its axes. Where absent, that of the uniformly filled closed surface, or of the area of an open "
       "one."},
      {"inertia", &S::inertia, "kg m2", positive(), optional,
       "Moments of inertia about the centre of mass, along the surface's axes. Where absent, those of the uniformly filled closed surface."},
      {"position", &S::position, "m", any_number(), optional, "Position of the surface's origin at t = 0."},
      {"velocity", &S::velocity, "m/s", any_number(), optional, "Velocity of the centre of mass at t = 0; constrained degrees of freedom keep it."},
      {"angular_velocity", &S::angular_velocity, "rad/s", any_number(), optional, "Angular velocity at t = 0; constrained degrees of freedom keep it."},
      {"free_dofs",
       &S::free_dofs,
       "",
       {},
       optional,
       "Free degrees of freedom, which contact and loads may change, of x, y, z, rx, ry, rz. The others keep their given velocity or follow motion.",
       degree_words}};
  return all;
}

}  // namespace perimpact
