#include "perimpact/deck_model/setup.hpp"

#include <numbers>
#include <utility>

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<RelaxSetup>> RelaxSetup::fields() {
  using S = RelaxSetup;
  static const Field<S> all[] = {
      {"increments", &S::increments, "1", between(1, 1e6), optional,
       "Number of increments, each an equilibrium state, equally spaced in time up to the end of the run. Boundary conditions and loads are those of its "
       "time."},
      {"tolerance", &S::tolerance, "1", strictly_between(0, 1), optional,
       "Convergence tolerance: an increment has converged when the residual forces are below this share of applied forces and reactions."},
      {"max_iterations", &S::max_iterations, "1", between(1, 1e9), optional,
       "Maximum number of iterations of an increment; beyond it the run ends with an error."}};
  return all;
}

std::span<const Field<TimeSetup>> TimeSetup::fields() {
  static const Field<TimeSetup> all[] = {
      {"end", &TimeSetup::end, "s", positive(), required, "Time at which the run ends."},
      {"step", &TimeSetup::step, "s", positive(), optional,
       "Time step. Where absent, 0.9 times the stable time step estimated after Silling and Askari, the smallest over all bodies."}};
  return all;
}

namespace {

enum class WithPoissonsRatio { no, yes };

/// The fields common to all materials.
template <class S>
std::vector<Field<S>> elastic_fields(WithPoissonsRatio poisson, std::vector<Field<S>> own = {}) {
  std::vector<Field<S>> all{{"youngs_modulus", &S::youngs_modulus, "Pa", positive(), optional, "Young's modulus E. Required, unless ice gives it."}};
  if (poisson == WithPoissonsRatio::yes)
    all.push_back({"poissons_ratio", &S::poissons_ratio, "1", strictly_between(-1, 0.5), optional,
                   std::is_same_v<S, CorrespondenceSetup>
                       ? "Poisson's ratio ν: an isotropic solid needs -1 < ν < 0.5. Ice is usually 0.25 to 0.35."
                       : "Poisson's ratio ν: an isotropic solid needs -1 < ν < 0.5. Ice is usually 0.25 to 0.35. 0.25 is the fastest."});
  all.push_back({"density", &S::density, "kg/m3", positive(), required, "Mass density ρ."});
  all.push_back({"critical_stretch", &S::critical_stretch, "1", positive(), optional,
                 "A bond whose stretch exceeds this fails irreversibly. Where critical_stretch, fracture_energy and flexural_strength are all absent, bonds "
                 "never break."});
  all.push_back({"fracture_energy", &S::fracture_energy, "J/m2", positive(), optional,
                 "In place of critical_stretch: fracture energy G₀ per unit area of crack (critical energy release rate)."});
  all.push_back({"flexural_strength", &S::flexural_strength, "Pa", positive(), optional,
                 "In place of critical_stretch: surface stress at which a plate fails in bending; critical stretch (1 - 1/n) σ/E with n layers of particles."});
  all.push_back({"layers", &S::layers, "1", between(2, 1000), optional,
                 "Layers of particles through the thickness in bending, for flexural_strength. Where absent, those across the thinnest direction."});
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

template <class S>
Field<S> influence_field() {
  return {"influence",
          &S::influence,
          "",
          {},
          optional,
          "Influence function of the bond length r = |ξ|/δ: constant, inverse (1/r), inverse-square, parabolic (1 up to 1/2, then 4 r (1 - r)) or gaussian "
          "(exp(-(r/0.4)²))."};
}

}  // namespace

std::span<const Field<IceSetup>> IceSetup::fields() {
  using S = IceSetup;
  static const Field<S> all[] = {
      {"temperature", &S::temperature, "degC", between(-22.9, -0.5), optional, "Temperature of the ice, averaged over its thickness."},
      {"salinity", &S::salinity, "g/kg", between(0, 35), optional, "Salinity of the ice; 0 is freshwater ice."},
      {"brine_volume", &S::brine_volume, "1", between(0, 0.25), optional,
       "In place of temperature and salinity: brine volume fraction, 0.05 for 50 parts per thousand."},
      {"thickness", &S::thickness, "m", positive(), optional,
       "Thickness of the ice in bending, in place of layers. Where both are absent, the body's thinnest direction."}};
  return all;
}

std::span<const Field<PlasticitySetup>> PlasticitySetup::fields() {
  using S = PlasticitySetup;
  static const Field<S> all[] = {
      {"surface",
       &S::surface,
       "",
       {},
       optional,
       "Yield surface J2 = a0 + a1 p + a2 p², by its source: riska-frederking (uniaxial compressive strength 4.43 MPa), derradji-aouat (9.35 MPa), kierkegaard "
       "(9.0 MPa), or von-mises (J2 = σ²/3 at every pressure; needs compressive_strength)."},
      {"compressive_strength", &S::compressive_strength, "Pa", positive(), optional,
       "Uniaxial compressive strength to which the surface of Riska and Frederking is scaled, or that of von-mises."},
      {"failure_strain", &S::failure_strain, "1", positive(), optional,
       "ε0: a particle loses its cohesion where its equivalent plastic strain exceeds ε0 + ((p/p2 - N)/M)², p its pressure and p2 that at which the surface "
       "closes."},
      {"failure_width", &S::failure_width, "1", positive(), optional, "M in that formula."},
      {"failure_pressure", &S::failure_pressure, "1", at_least(0), optional, "N in that formula: the share of p2 at which ice fails first."},
      {"friction_angle", &S::friction_angle, "rad", between(0, 1.4), optional,
       "Angle of internal friction of ice that has failed: from then on its shear strength is that of a granular material, J2 <= c p², c = 12 sin²φ/(3 - sin φ)². "
       "Where absent, failed ice keeps its shear strength and loses its tensile strength alone."}};
  return all;
}

std::span<const Field<OrdinaryStateSetup>> OrdinaryStateSetup::fields() {
  static const auto all = elastic_fields<OrdinaryStateSetup>(WithPoissonsRatio::yes);
  return all;
}

std::span<const Field<LinearSolidSetup>> LinearSolidSetup::fields() {
  static const auto all = elastic_fields<LinearSolidSetup>(WithPoissonsRatio::yes, {influence_field<LinearSolidSetup>()});
  return all;
}

std::span<const Field<BondBasedSetup>> BondBasedSetup::fields() {
  static const auto all = elastic_fields<BondBasedSetup>(WithPoissonsRatio::no);
  return all;
}

std::span<const Field<CorrespondenceSetup>> CorrespondenceSetup::fields() {
  using S = CorrespondenceSetup;
  static const auto all = elastic_fields<S>(
      WithPoissonsRatio::yes, {{"law",
                                &S::law,
                                "",
                                {},
                                optional,
                                "Stress-strain law at finite strain: hencky (linear in the logarithmic strain) or st-venant-kirchhoff (linear in the "
                                "Green-Lagrange strain; it softens in compression to 0.58 of the length)."},
                               {"stabilisation",
                                &S::stabilisation,
                                "",
                                {},
                                optional,
                                "Control of zero-energy modes, to which deformation gradients are blind: bond-level (bonds are compared with the mean gradient "
                                "of their ends, so that bending and torsion are not resisted) or, at half the cost, wan or silling (gradient of each end: for "
                                "strains that are uniform within a horizon; thin bodies bend several times too stiffly)."},
                               {"stabilisation_factor", &S::stabilisation_factor, "1", positive(), optional, "Factor on the stiffness of the stabilisation."},
                               influence_field<S>()});
  return all;
}

std::span<const Field<FailureSetup>> FailureSetup::fields() {
  using S = FailureSetup;
  static const Field<S> all[] = {{"compression",
                                  &S::compression,
                                  "",
                                  {},
                                  optional,
                                  "Bond failure in compression: none, symmetric (at minus the critical stretch) or limit (at critical_compression)."},
                                 {"critical_compression", &S::critical_compression, "1", strictly_between(0, 1), optional,
                                  "With compression: limit, a bond whose compressive stretch exceeds this fails."},
                                 {"compression_hardening", &S::compression_hardening, "1", between(0, 1), optional,
                                  "Confinement-dependent critical stretch: it grows by α times the largest compression of a bond of the two particles (their "
                                  "mean). In uniaxial compression a body of ν = 0.25 is then 1/(0.37 - α) times as strong as in tension: 0.17 for 5, 0.27 for "
                                  "10, as for ice. It adds a third to a half to the cost of a force evaluation."},
                                 {"weibull_modulus", &S::weibull_modulus, "1", between(1, 1000), optional,
                                  "Scatter: the critical stretch of each particle is multiplied by a Weibull-distributed random factor with this modulus and "
                                  "mean 1; a bond takes the mean of its two particles. Where absent, no scatter."},
                                 {"seed", &S::seed, "1", between(0, 2147483647), optional, "Seed of the random factors; the same seed gives the same body."},
                                 {"no_fail", &S::no_fail, "", {}, optional, "Names of particle sets of the body whose particles never lose a bond."}};
  return all;
}

std::span<const Field<BodySetup>> BodySetup::fields() {
  using S = BodySetup;
  static const Field<S> all[] = {
      {"spacing", &S::spacing, "m", positive(), optional,
       "Particle spacing Δ of the lattice. Required, except for the shapes points and cells, which have none."},
      {"horizon_ratio", &S::horizon_ratio, "1", between(2, 6), optional, "Horizon δ over the particle spacing, m = δ/Δ."},
      {"position", &S::position, "m", any_number(), optional,
       "Position at t = 0 of the centre of the shape, or of the origin of its file. Added solids, holes, cracks and particle sets are relative to it."},
      {"rotate", &S::rotate, "rad", between(-6.2832, 6.2832), optional,
       "Rotates the shape with its added solids, holes, cracks and particle sets about the axes x, y and z through the position, in this order. The lattice "
       "stays aligned with the axes."},
      {"velocity", &S::velocity, "m/s", any_number(), optional, "Initial velocity of all particles."},
      {"family",
       &S::family,
       "",
       {},
       optional,
       "Family of a particle and the partial volumes of its neighbours: hu-ha-bobaru (|ξ| < δ + Δ/2) or madenci-oterkus (|ξ| <= δ)."},
      {"normalisation",
       &S::normalisation,
       "",
       {},
       optional,
       "lattice: bond constants are scaled so that the interior lattice has exactly the given moduli; continuum: those of the continuum integral "
       "(micromodulus)."},
      {"surface_correction",
       &S::surface_correction,
       "",
       {},
       optional,
       "Surface effect correction, for the missing bonds near a surface: energy (Madenci and Oterkus, interpolated), volume (Le and Bobaru) or none. "
       "automatic: energy; none for the models linear-peridynamic-solid and correspondence, which normalise each particle by its own family."},
      {"bending_calibration",
       &S::bending_calibration,
       "",
       {},
       optional,
       "x, y or z: the axis across a thin plate. All bonds are stiffened by one factor so that its few layers have the bending stiffness of a plate; in-plane, "
       "the plate is too stiff by the same factor. For three to six layers. none: no factor."},
      {"plane",
       &S::plane,
       "",
       {},
       optional,
       "stress or strain: a 2-D body in plane stress or plane strain, one layer of particles in z as thick as the solid; all motion lies in x and y. none: "
       "3-D."},
      {"published",
       &S::published,
       "",
       {},
       optional,
       "true: the discretisation of Zhang et al. (the FCCDA paper), that is family madenci-oterkus, normalisation continuum, surface_correction none; these "
       "keys must then be absent."}};
  return all;
}

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

std::span<const Field<BoxRegionSetup>> BoxRegionSetup::fields() {
  using S = BoxRegionSetup;
  static const Field<S> all[] = {{"size", &S::size, "m", positive(), required, "Edge lengths along the surface's axes."},
                                 {"centre", &S::centre, "m", any_number(), optional, "Centre, relative to the surface's origin."}};
  return all;
}

std::span<const Field<BoundsBoxSetup>> BoundsBoxSetup::fields() {
  using S = BoundsBoxSetup;
  static const Field<S> all[] = {{"size", &S::size, "m", positive(), required, "Edge lengths along the surface's axes."},
                                 {"centre", &S::centre, "m", any_number(), optional, "Centre, relative to the surface's origin."}};
  return all;
}

std::span<const Field<BoxUnionBoundsSetup>> BoxUnionBoundsSetup::fields() {
  using S = BoxUnionBoundsSetup;
  static const Field<S> all[] = {
      {"count", &S::count, "1", between(1, 1000), optional, "Maximum number of boxes fitted to the surface. Where absent, 32."},
      {"gain", &S::gain, "1", between(0, 1), optional,
       "Boxes are fitted to the surface as long as a further one saves at least this share of the bounding box. Where absent, 0.003."}};
  return all;
}

std::span<const Field<CylinderSectorsBoundsSetup>> CylinderSectorsBoundsSetup::fields() {
  using S = CylinderSectorsBoundsSetup;
  static const Field<S> all[] = {
      {"axis", &S::axis, "1", any_number(), optional, "Direction of the axis in the surface's axes. Where absent, fitted, as are all keys here."},
      {"point", &S::point, "m", any_number(), optional, "Centre of the cylinder, relative to the surface's origin."},
      {"radius", &S::radius, "m", positive(), optional, "Radius of the cylinder."},
      {"length", &S::length, "m", positive(), optional, "Length of the cylinder."},
      {"hub_radius", &S::hub_radius, "m", at_least(0), optional, "Radius within which there are no gaps between sectors."},
      {"blades", &S::blades, "1", between(1, 1000), optional, "Number of equally spaced sectors."},
      {"sector_angle", &S::sector_angle, "rad", between(0, 2 * std::numbers::pi), optional, "Width of each sector. Half a turn or more: no gaps."},
      {"start_angle", &S::start_angle, "rad", any_number(), optional,
       "Start of the first sector: about the axis z from x towards y, about x from y towards z, about y from z towards x. Requires sector_angle."}};
  return all;
}

std::span<const Field<AutoBoundsSetup>> AutoBoundsSetup::fields() { return {}; }

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
       "Factor on force and moment at each time, interpolated linearly; constant before the first time and after the last. Where absent, 1."}};
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
       "Free degrees of freedom, which contact and loads may change, of x, y, z, rx, ry, rz. The others keep their given velocity or follow motion."}};
  return all;
}

std::span<const Field<ImpactorContactSetup>> ImpactorContactSetup::fields() {
  using S = ImpactorContactSetup;
  static const Field<S> all[] = {{"detector",
                                  &S::detector,
                                  "",
                                  {},
                                  optional,
                                  "swept (continuous collision detection; never misses), published (panel test of Zhang et al.) or analytic (distance to the "
                                  "centre; sphere and cylinder only)."},
                                 {"variant",
                                  &S::variant,
                                  "",
                                  {},
                                  optional,
                                  "Variant of the published detector: corrected, or literal (as printed in the paper). The other detectors do not use it."},
                                 {"friction", &S::friction, "1", at_least(0), optional,
                                  "Coulomb friction coefficient between particles and impactors. The published detector requires 0."},
                                 {"radius_ratio", &S::radius_ratio, "1", between(0, 1), optional,
                                  "Contact radius over the particle spacing: a particle is in contact at this distance from the surface. 0.5 places contact at "
                                  "the edge of the material, 0 at the particle centres as in the FCCDA paper. The published detector requires 0, its default."},
                                 {"initial_overlap",
                                  &S::initial_overlap,
                                  "",
                                  {},
                                  optional,
                                  "Treatment of particles that are inside an impactor at t = 0, or nearer to it than the contact radius: error; remove (they "
                                  "are left out and the body has a hole there); project (they are moved onto the surface and their bonds start strained)."}};
  return all;
}

std::span<const Field<FragmentContactSetup>> FragmentContactSetup::fields() {
  using S = FragmentContactSetup;
  static const Field<S> all[] = {
      {"law",
       &S::law,
       "",
       {},
       optional,
       "Short-range force between particles without an intact bond, of one body or of two: none (they pass through one another) or repulsive."},
      {"distance_ratio", &S::distance_ratio, "1", positive(), optional,
       "Distance at which faces of particles without a bond are in contact, of one body or of two, over the mean spacing of the two. 1: half a spacing each, "
       "as for impactors, so that the edges of the material meet."},
      {"stiffness_factor", &S::stiffness_factor, "1", positive(), optional,
       "Penalty stiffness of contact: two faces act as if each pair of opposite particles had this many times the spring stiffness of a bond. The value 15 is "
       "that of EMU."},
      {"friction", &S::friction, "1", at_least(0), optional, "Coulomb friction coefficient between particles in contact. Ice on ice has 0.1 to 0.3."},
      {"restitution", &S::restitution, "1", between(0.1, 1), optional,
       "Coefficient of restitution of two free particles, separation speed over approach speed: 1 is without loss. Smaller values require shorter time "
       "steps."}};
  return all;
}

std::span<const Field<ProbeSetup>> ProbeSetup::fields() {
  static const Field<ProbeSetup> all[] = {
      {"body", &ProbeSetup::body, "", {}, required, "Name of the body."},
      {"at", &ProbeSetup::at, "m", any_number(), required,
       "Point in the reference (undeformed) configuration. Displacements are the mean of the particles nearest to it (up to eight, equally near)."}};
  return all;
}

std::span<const Field<LineSetup>> LineSetup::fields() {
  using S = LineSetup;
  static const Field<S> all[] = {{"body", &S::body, "", {}, required, "Name of the body."},
                                 {"from", &S::from, "m", any_number(), required, "One end, in the reference (undeformed) configuration."},
                                 {"to", &S::to, "m", any_number(), required, "The other end."},
                                 {"times", &S::times, "s", at_least(0), optional, "Output times. Where absent, the end of the run."}};
  return all;
}

std::span<const Field<OutputSetup>> OutputSetup::fields() {
  using S = OutputSetup;
  static const Field<S> all[] = {
      {"folder", &S::folder, "", {}, optional, "Folder of the results, relative to the working directory; --out overrides it."},
      {"frames", &S::frames, "1", between(0, 100000), optional, "Number of output frames after the one at t = 0. 0: none."},
      {"history_interval", &S::history_interval, "s", positive(), optional, "Time between rows of history.csv. Where absent, a hundredth of the run."},
      {"checkpoint_interval", &S::checkpoint_interval, "s", at_least(0), optional,
       "Wall-clock time between checkpoints, from which a stopped run can be restarted (perimpact run DECK --resume). One is always written at the end and "
       "when the run is interrupted; 0: no others."}};
  return all;
}

std::span<const Field<Setup>> Setup::fields() {
  static const Field<Setup> all[] = {{"title", &Setup::title, "", {}, optional, "One line that describes the simulation."}};
  return all;
}

}  // namespace perimpact
