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
       "Number of states of equilibrium, evenly spread to the end of the run. At each, courses and loads are as at its time."},
      {"tolerance", &S::tolerance, "1", strictly_between(0, 1), optional,
       "An increment is done when the forces that are out of balance are less than this share of the applied ones and those that hold."},
      {"max_iterations", &S::max_iterations, "1", between(1, 1e9), optional, "An increment that takes more iterations ends the run."}};
  return all;
}

std::span<const Field<TimeSetup>> TimeSetup::fields() {
  static const Field<TimeSetup> all[] = {
      {"end", &TimeSetup::end, "s", positive(), required, "Time at which the run ends."},
      {"step", &TimeSetup::step, "s", positive(), optional, "Time step. Where absent, 0.9 times the stable estimate of Silling and Askari over all bodies."}};
  return all;
}

namespace {

enum class WithPoissonsRatio { no, yes };

/// The fields of what all materials have.
template <class S>
std::vector<Field<S>> elastic_fields(WithPoissonsRatio poisson, std::vector<Field<S>> own = {}) {
  std::vector<Field<S>> all{{"youngs_modulus", &S::youngs_modulus, "Pa", positive(), optional, "Young's modulus E. Needed, unless ice gives it."}};
  if (poisson == WithPoissonsRatio::yes)
    all.push_back({"poissons_ratio", &S::poissons_ratio, "1", strictly_between(-1, 0.5), optional,
                   std::is_same_v<S, CorrespondenceSetup>
                       ? "Poisson's ratio ν: an isotropic solid needs -1 < ν < 0.5. Ice is usually 0.25 to 0.35."
                       : "Poisson's ratio ν: an isotropic solid needs -1 < ν < 0.5. Ice is usually 0.25 to 0.35. 0.25 is the fastest."});
  all.push_back({"density", &S::density, "kg/m3", positive(), required, "Mass density ρ."});
  all.push_back({"critical_stretch", &S::critical_stretch, "1", positive(), optional,
                 "A bond longer than (1 + this) times its first length breaks for ever. Where this, fracture_energy and flexural_strength are absent, bonds "
                 "never break."});
  all.push_back({"fracture_energy", &S::fracture_energy, "J/m2", positive(), optional,
                 "In place of critical_stretch: the energy G₀ that it takes to part the body, for each area of crack."});
  all.push_back({"flexural_strength", &S::flexural_strength, "Pa", positive(), optional,
                 "In place of critical_stretch: the stress at the surface of a bent plate at which it breaks; critical stretch (1 - 1/n) σ/E with n layers of "
                 "particles."});
  all.push_back({"layers", &S::layers, "1", between(2, 1000), optional,
                 "Layers of particles through the thickness that bends, for flexural_strength. Where absent, those of the thinnest direction."});
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
          "How much a bond counts by its length, r = |ξ|/δ: one, inverse (1/r), inverse-square, parabolic (1 up to 1/2, then 4 r (1 - r)) or gaussian "
          "(exp(-(r/0.4)²))."};
}

}  // namespace

std::span<const Field<IceSetup>> IceSetup::fields() {
  using S = IceSetup;
  static const Field<S> all[] = {
      {"temperature", &S::temperature, "degC", between(-22.9, -0.5), optional, "Temperature of the ice, the mean over its thickness."},
      {"salinity", &S::salinity, "g/kg", between(0, 35), optional, "Salinity of the ice; 0 is fresh-water ice."},
      {"brine_volume", &S::brine_volume, "1", between(0, 0.25), optional,
       "In place of temperature and salinity: share of the ice's volume that is brine, 0.05 for 50 parts in a thousand."},
      {"thickness", &S::thickness, "m", positive(), optional,
       "Thickness of the ice that bends, in place of layers. Where both are absent, the body's thinnest direction."}};
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
      {"failure_pressure", &S::failure_pressure, "1", at_least(0), optional, "N in that formula: the share of p2 at which ice fails first."}};
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
      WithPoissonsRatio::yes,
      {{"law",
        &S::law,
        "",
        {},
        optional,
        "Stress of a finite strain: hencky (linear in the logarithmic strain) or st-venant-kirchhoff (linear in Green's strain, which grows soft where the "
        "material is squeezed to 0.58 of its length)."},
       {"stabilisation",
        &S::stabilisation,
        "",
        {},
        optional,
        "What resists zero-energy modes, displacements that deformation gradients do not see: bond-level (bonds are compared with the mean gradient of "
        "their ends, so that bending and torsion are not resisted), or, for half the cost, wan or silling (with the gradient of each end: for strains that "
        "are uniform within a horizon; thin bodies bend several times too stiffly)."},
       {"stabilisation_factor", &S::stabilisation_factor, "1", positive(), optional, "Multiplies the stiffness of the stabilisation."},
       influence_field<S>()});
  return all;
}

std::span<const Field<FailureSetup>> FailureSetup::fields() {
  using S = FailureSetup;
  static const Field<S> all[] = {
      {"compression",
       &S::compression,
       "",
       {},
       optional,
       "Whether bonds break in compression: none, symmetric (at the critical stretch too) or limit (at critical_compression)."},
      {"critical_compression", &S::critical_compression, "1", strictly_between(0, 1), optional,
       "A bond shorter than (1 - this) times its first length breaks, with compression: limit."},
      {"compression_hardening", &S::compression_hardening, "1", between(0, 1), optional,
       "α: the critical stretch grows by this times the largest compression of a bond of the two particles (their mean). Squeezed along one axis, "
       "a body of ν = 0.25 is then 1/(0.37 - α) times as strong as pulled: 0.17 for 5, 0.27 for 10, as ice has. It costs a third to a half of an evaluation of "
       "forces."},
      {"weibull_modulus", &S::weibull_modulus, "1", between(1, 1000), optional,
       "Scatter: the critical stretch of each particle is multiplied by a random factor of Weibull's distribution with this modulus and mean 1; a bond takes "
       "the mean of its two. Where absent, no scatter."},
      {"seed", &S::seed, "1", between(0, 2147483647), optional, "Chooses the random factors; the same seed gives the same body."},
      {"no_fail", &S::no_fail, "", {}, optional, "Names of regions of the body whose particles never lose a bond."}};
  return all;
}

std::span<const Field<BodySetup>> BodySetup::fields() {
  using S = BodySetup;
  static const Field<S> all[] = {
      {"spacing", &S::spacing, "m", positive(), optional,
       "Distance between neighbouring particles of the lattice. Shapes of points and cells have none, all others need it."},
      {"horizon_ratio", &S::horizon_ratio, "1", between(2, 6), optional, "Horizon δ in spacings."},
      {"position", &S::position, "m", any_number(), optional,
       "Where the centre of the shape is at t = 0, or the origin of its file. Parts, holes, cracks and regions are placed from here."},
      {"rotate", &S::rotate, "rad", between(-6.2832, 6.2832), optional,
       "Turns the shape, with parts, holes, cracks and regions, about the axes x, y and z through the position, in this order. The lattice stays along the "
       "axes."},
      {"velocity", &S::velocity, "m/s", any_number(), optional, "Velocity of all particles at t = 0."},
      {"family",
       &S::family,
       "",
       {},
       optional,
       "Which particles are bonded and with which part of their volume: hu-ha-bobaru (|ξ| < δ + Δ/2) or madenci-oterkus (|ξ| <= δ)."},
      {"normalisation",
       &S::normalisation,
       "",
       {},
       optional,
       "lattice: the bond constants are scaled so that the interior lattice has exactly the given moduli; continuum: used as in the integral."},
      {"surface_correction",
       &S::surface_correction,
       "",
       {},
       optional,
       "What makes up for the missing bonds near a surface: energy (Madenci and Oterkus, interpolated), volume (Le and Bobaru) or none. automatic: energy; "
       "none for the models linear-peridynamic-solid and correspondence, which normalise each particle by its own family."},
      {"bending_calibration",
       &S::bending_calibration,
       "",
       {},
       optional,
       "x, y or z: the axis across a thin plate. All bonds are made stiffer by one factor, so that the bending stiffness of its few layers is that of a "
       "plate; stretched in its plane it is too stiff by the same factor. For three to six layers. none: no factor."},
      {"plane",
       &S::plane,
       "",
       {},
       optional,
       "stress or strain: a body of two dimensions, one layer of particles in z as thick as the solid; all motion lies in x and y. none: three dimensions."},
      {"published",
       &S::published,
       "",
       {},
       optional,
       "true: the discretisation of the seed paper, that is family madenci-oterkus, normalisation continuum, surface_correction none; the three may then not "
       "be given."}};
  return all;
}

std::span<const Field<CylinderSurface>> CylinderSurface::fields() {
  using S = CylinderSurface;
  static const Field<S> all[] = {{"diameter", &S::diameter, "m", positive(), required, "Diameter."},
                                 {"height", &S::height, "m", positive(), required, "Length along the axis, centred on the origin."},
                                 {"axis", &S::axis, "", {}, optional, "Direction of the axis: x, y or z."},
                                 {"edge_length", &S::edge_length, "m", positive(), required,
                                  "Largest edge of the panels around, along and between the rings of the caps. Diagonals of triangles reach 1.41 times it."},
                                 {"panel_shape", &S::panel_shape, "", {}, optional, "triangles or quads."}};
  return all;
}

std::span<const Field<SphereSurface>> SphereSurface::fields() {
  using S = SphereSurface;
  static const Field<S> all[] = {{"diameter", &S::diameter, "m", positive(), required, "Diameter."},
                                 {"edge_length", &S::edge_length, "m", positive(), required, "Largest edge of the panels."}};
  return all;
}

std::span<const Field<BoxSurface>> BoxSurface::fields() {
  using S = BoxSurface;
  static const Field<S> all[] = {
      {"size", &S::size, "m", positive(), required, "Edge lengths in x, y and z, centred on the origin."},
      {"edge_length", &S::edge_length, "m", positive(), required, "Largest edge of the panels along x, y and z. Diagonals of triangles reach 1.41 times it."},
      {"panel_shape", &S::panel_shape, "", {}, optional, "triangles or quads."}};
  return all;
}

std::span<const Field<FileSurface>> FileSurface::fields() {
  using S = FileSurface;
  constexpr double full_turn = 6.2832;  // [rad] somewhat more, for rounding; 90 without its unit is beyond
  static const Field<S> all[] = {
      {"file",
       &S::file,
       "",
       {},
       required,
       "A mesh: STL, OBJ, PLY, OFF, VTK, VTP, VTU, MSH (Gmsh), INP (Abaqus), K, KEY or DYN (LS-DYNA), each also packed as .gz; STEP and IGES if gmsh is "
       "installed. A relative path starts at the deck's folder."},
      {"file_parts", &S::file_parts, "", {}, optional, "Names of the parts of the file that are wanted; all where absent. `perimpact mesh` lists them."},
      {"scale", &S::scale, "1", positive(), optional, "Multiplies the coordinates, so that they become metres: 0.001 for a file in millimetres."},
      {"mirror", &S::mirror, "", {}, optional, "Mirrors the surface at the plane x = 0, y = 0 or z = 0: turns left into right."},
      {"mirror_merge",
       &S::mirror_merge,
       "",
       {},
       optional,
       "Adds the mirror image at the plane x = 0, y = 0 or z = 0: for a file that holds half of a ship, y. Panels in that plane go."},
      {"rotate", &S::rotate, "rad", between(-full_turn, full_turn), optional,
       "Turns the surface about the axes x, y and z through the origin, in this order: [90 deg, 0, 0]."},
      {"translate", &S::translate, "m", any_number(), optional, "Moves the surface. Scale, mirror, complete, rotate and translate act in this order."},
      {"weld", &S::weld, "m", positive(), optional,
       "Vertices nearer than this become one: closes gaps that rounding left between panels. Where absent, 1e-9 of the surface's size. `perimpact mesh` says "
       "what would close a surface."},
      {"orientation",
       &S::orientation,
       "",
       {},
       optional,
       "Which side of an open surface is outside: normals (the side the panels' normals point to) or reversed. Closed surfaces find it themselves."}};
  return all;
}

std::span<const Field<BoxRegionSetup>> BoxRegionSetup::fields() {
  using S = BoxRegionSetup;
  static const Field<S> all[] = {{"size", &S::size, "m", positive(), required, "Edge lengths along the surface's own axes."},
                                 {"centre", &S::centre, "m", any_number(), optional, "Centre, from the surface's origin."}};
  return all;
}

std::span<const Field<BoundsBoxSetup>> BoundsBoxSetup::fields() {
  using S = BoundsBoxSetup;
  static const Field<S> all[] = {{"size", &S::size, "m", positive(), required, "Edge lengths along the surface's own axes."},
                                 {"centre", &S::centre, "m", any_number(), optional, "Centre, from the surface's origin."}};
  return all;
}

std::span<const Field<BoxUnionBoundsSetup>> BoxUnionBoundsSetup::fields() {
  using S = BoxUnionBoundsSetup;
  static const Field<S> all[] = {{"count", &S::count, "1", between(1, 1000), optional, "Fits at most so many boxes to the surface. Where absent, 32 at most."},
                                 {"gain", &S::gain, "1", between(0, 1), optional,
                                  "Fits boxes to the surface as long as a further one saves at least this share of the bounding box. Where absent, 0.003."}};
  return all;
}

std::span<const Field<CylinderSectorsBoundsSetup>> CylinderSectorsBoundsSetup::fields() {
  using S = CylinderSectorsBoundsSetup;
  static const Field<S> all[] = {
      {"axis", &S::axis, "1", any_number(), optional, "Direction of the axis in the surface's own axes. Fitted where absent, as everything here."},
      {"point", &S::point, "m", any_number(), optional, "Middle of the cylinder, from the surface's origin."},
      {"radius", &S::radius, "m", positive(), optional, "Radius of the cylinder."},
      {"length", &S::length, "m", positive(), optional, "Length of the cylinder."},
      {"hub_radius", &S::hub_radius, "m", at_least(0), optional, "Within this radius there are no gaps."},
      {"blades", &S::blades, "1", between(1, 1000), optional, "Number of sectors, at equal angles."},
      {"sector_angle", &S::sector_angle, "rad", between(0, 2 * std::numbers::pi), optional, "Width of each sector. Half a turn and more: no gaps."},
      {"start_angle", &S::start_angle, "rad", any_number(), optional,
       "Where the first sector begins: about the axis z from x towards y, about x from y towards z, about y from z towards x. Needs sector_angle."}};
  return all;
}

std::span<const Field<AutoBoundsSetup>> AutoBoundsSetup::fields() { return {}; }

std::span<const Field<ContactBoundsSetup>> ContactBoundsSetup::fields() {
  static const Field<ContactBoundsSetup> all[] = {{"on_exceed",
                                                   &ContactBoundsSetup::on_exceed,
                                                   "",
                                                   {},
                                                   optional,
                                                   "What a panel outside the region means: error, or clip (there is no contact beyond the region)."}};
  return all;
}

std::span<const Field<RefinementSetup>> RefinementSetup::fields() {
  using S = RefinementSetup;
  static const Field<S> all[] = {
      {"edge_length", &S::edge_length, "m", positive(), required, "Longest edge that panels shall have there. Panels are halved until none is longer."},
      {"surface_part", &S::surface_part, "", {}, optional, "Only panels of this part of the surface. Where absent, of all parts."},
      {"angle", &S::angle, "rad", strictly_between(0, std::numbers::pi), optional,
       "An angle such as 10 deg: only where the surface curves, panels become so small that they turn by it at most, but not smaller than edge_length; at "
       "creases "
       "they are that small. Where absent, curved or not."}};
  return all;
}

std::span<const Field<CoarseningSetup>> CoarseningSetup::fields() {
  using S = CoarseningSetup;
  static const Field<S> all[] = {
      {"max_deviation", &S::max_deviation, "m", positive(), required,
       "No point of the surface moves by more than this. Exactly flat places need next to nothing."},
      {"max_edge_length", &S::max_edge_length, "m", positive(), optional, "No edge is made longer than this. Where absent, any length will do."}};
  return all;
}

std::span<const Field<GaugeSetup>> GaugeSetup::fields() {
  using S = GaugeSetup;
  static const Field<S> all[] = {
      {"surface_parts", &S::surface_parts, "", {}, optional, "Names of parts of the surface (perimpact mesh lists them). Where absent, the whole surface."},
      {"point", &S::point, "m", any_number(), optional,
       "Point of the moments, from the surface's origin and along its axes; it moves with the impactor. Where absent, the centre of mass."},
      {"axis", &S::axis, "1", any_number(), optional,
       "Direction, along the surface's axes and turning with them, about which the torque is told too. Its length does not matter."}};
  return all;
}

std::span<const Field<TranslationTable>> TranslationTable::fields() {
  using S = TranslationTable;
  static const Field<S> all[] = {
      {"times", &S::times, "s", any_number(), optional, "Times of the points, increasing. Values between them follow a straight line."},
      {"velocities", &S::velocities, "m/s", any_number(), optional,
       "Velocity at each time. Before the first time the first one holds, after the last time the last one."},
      {"displacements", &S::displacements, "m", any_number(), optional,
       "In place of velocities: displacement at each time. Only differences matter: at t = 0 the impactor is at its position. It rests before the first "
       "time and after the last one."},
      {"file",
       &S::file,
       "",
       {},
       optional,
       "In place of the lists: a CSV file with two columns and a first line that names them with units, \"time [s], velocity [m/s]\" or \"time [s], "
       "displacement [m]\"; a relative path starts at the deck's folder."}};
  return all;
}

std::span<const Field<RotationTable>> RotationTable::fields() {
  using S = RotationTable;
  static const Field<S> all[] = {
      {"times", &S::times, "s", any_number(), optional, "Times of the points, increasing. Values between them follow a straight line."},
      {"velocities", &S::velocities, "rad/s", any_number(), optional,
       "Angular velocity at each time. Before the first time the first one holds, after the last time the last one."},
      {"displacements", &S::displacements, "rad", any_number(), optional,
       "In place of velocities: angle at each time, for the only axis that the impactor turns about. Only differences matter. It rests before the first time "
       "and after the last one."},
      {"file",
       &S::file,
       "",
       {},
       optional,
       "In place of the lists: a CSV file with two columns and a first line that names them with units, \"time [s], velocity [rad/s]\" or \"time [s], "
       "displacement [rad]\"; a relative path starts at the deck's folder."}};
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
      {"force", &S::force, "N", any_number(), optional, "Force along the axes of the world."},
      {"moment", &S::moment, "N m", any_number(), optional, "Moment about the axes of the world, beside that of the force."},
      {"point", &S::point, "m", any_number(), optional,
       "Where the force acts, from the surface's origin and along its axes; it moves with the impactor. Where absent, the centre of mass."},
      {"times", &S::times, "s", any_number(), optional, "Times of the factors, increasing."},
      {"factors", &S::factors, "1", any_number(), optional,
       "What force and moment are multiplied by at each time, on straight lines between; the first holds before, the last after. Where absent, 1."}};
  return all;
}

std::span<const Field<FloatingImpactorSetup>> FloatingImpactorSetup::fields() {
  using S = FloatingImpactorSetup;
  static const Field<S> all[] = {
      {"level", &S::level, "m", any_number(), optional, "Height z of the water's surface."},
      {"density", &S::density, "kg/m3", positive(), optional, "Density of the water."},
      {"gravity", &S::gravity, "m/s2", positive(), optional, "Acceleration of gravity, along -z."},
      {"added_mass", &S::added_mass, "1", at_least(0), optional,
       "Water that comes along with vertical motion, as a share of the water that the impactor displaces at rest: of its mass, or of all that its surface "
       "holds where it is heavier."},
      {"damping", &S::damping, "1/s", at_least(0), optional, "While in the water, v_z, ω_x and ω_y lose this share of themselves per second."}};
  return all;
}

std::span<const Field<ImpactorSetup>> ImpactorSetup::fields() {
  using S = ImpactorSetup;
  static const Field<S> all[] = {
      {"mass", &S::mass, "kg", positive(), optional, "Mass; or give the density."},
      {"density", &S::density, "kg/m3", positive(), optional,
       "In place of the mass: density of a body that fills the closed surface evenly. Overlapping parts of a surface count twice."},
      {"centre_of_mass", &S::centre_of_mass, "m", any_number(), optional,
       "Centre of mass, from the surface's origin and along its axes. Where absent, that of the closed surface filled evenly, of an open one that of its "
       "area."},
      {"inertia", &S::inertia, "kg m2", positive(), optional,
       "Moments of inertia about the centre of mass, along the surface's axes. Where absent, those of the closed surface filled evenly."},
      {"position", &S::position, "m", any_number(), optional, "Where the surface's origin is at t = 0."},
      {"velocity", &S::velocity, "m/s", any_number(), optional, "Velocity of the centre of mass at t = 0; degrees of freedom that are not free keep it."},
      {"angular_velocity", &S::angular_velocity, "rad/s", any_number(), optional, "Angular velocity at t = 0; degrees of freedom that are not free keep it."},
      {"free_dofs",
       &S::free_dofs,
       "",
       {},
       optional,
       "Degrees of freedom that contact and loads may change, of x, y, z, rx, ry, rz. The others keep their given velocity, or follow motion."}};
  return all;
}

std::span<const Field<ImpactorContactSetup>> ImpactorContactSetup::fields() {
  using S = ImpactorContactSetup;
  static const Field<S> all[] = {
      {"detector",
       &S::detector,
       "",
       {},
       optional,
       "swept (never misses), published (the seed paper's panel test) or analytic (distance to the centre; sphere and cylinder only)."},
      {"variant", &S::variant, "", {}, optional, "How the published detector reads the paper: repaired, or letter (as printed). The others do not use it."},
      {"friction", &S::friction, "1", at_least(0), optional,
       "Coulomb's coefficient of friction between particles and impactors. The published detector takes 0 only."},
      {"radius_ratio", &S::radius_ratio, "1", between(0, 1), optional,
       "Contact radius in spacings: a particle touches at this distance from the surface. 0.5 puts the surface at the material's edge, 0 at the particles' "
       "centres as in the paper. The published detector takes 0 only, and has it where this is absent."},
      {"initial_overlap",
       &S::initial_overlap,
       "",
       {},
       optional,
       "What becomes of particles that are inside an impactor at t = 0, or nearer to it than the contact radius: error; remove (they do not exist, "
       "the body has a hole there); project (they are put on the surface, and bonds start strained)."}};
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
       "Force between particles that no intact bond joins, of one body or of two: none (they pass through one another), or repulsive."},
      {"distance_ratio", &S::distance_ratio, "1", positive(), optional,
       "Distance at which faces of particles without a bond touch, of one body or of two, in spacings, the mean of the two. 1: half a spacing each, as "
       "impactors have it, so that the material's edges meet."},
      {"stiffness_factor", &S::stiffness_factor, "1", positive(), optional,
       "How stiff contact is: two faces as if each pair of particles opposite one another had this many times the bond's spring. The 15 of EMU."},
      {"friction", &S::friction, "1", at_least(0), optional, "Coulomb's coefficient of friction between touching particles. Ice on ice has 0.1 to 0.3."},
      {"restitution", &S::restitution, "1", between(0.1, 1), optional,
       "Speed at which two free particles part, over that of their approach: 1 without loss. Less takes shorter time steps."}};
  return all;
}

std::span<const Field<ProbeSetup>> ProbeSetup::fields() {
  static const Field<ProbeSetup> all[] = {
      {"body", &ProbeSetup::body, "", {}, required, "Name of the body."},
      {"at", &ProbeSetup::at, "m", any_number(), required,
       "Point of the undeformed body. Displacements are the mean of the particles nearest to it (up to eight, equally near)."}};
  return all;
}

std::span<const Field<LineSetup>> LineSetup::fields() {
  using S = LineSetup;
  static const Field<S> all[] = {{"body", &S::body, "", {}, required, "Name of the body."},
                                 {"from", &S::from, "m", any_number(), required, "One end, in the undeformed body."},
                                 {"to", &S::to, "m", any_number(), required, "The other end."},
                                 {"times", &S::times, "s", at_least(0), optional, "When to write the line. Where absent, at the end."}};
  return all;
}

std::span<const Field<OutputSetup>> OutputSetup::fields() {
  using S = OutputSetup;
  static const Field<S> all[] = {
      {"folder", &S::folder, "", {}, optional, "Folder of the results, from the working folder; --out overrides it."},
      {"frames", &S::frames, "1", between(0, 100000), optional, "Number of pictures after the one at t = 0. 0: none."},
      {"history_interval", &S::history_interval, "s", positive(), optional, "Time between rows of history.csv. Where absent, a hundredth of the run."},
      {"checkpoint_interval", &S::checkpoint_interval, "s", at_least(0), optional,
       "Time on the clock on the wall, not in the simulation, between checkpoints: from the last one a run that was stopped goes on (perimpact run DECK "
       "--resume). There is always one at the end and when the run is interrupted; 0: no others."}};
  return all;
}

std::span<const Field<Setup>> Setup::fields() {
  static const Field<Setup> all[] = {{"title", &Setup::title, "", {}, optional, "One line that says what is simulated."}};
  return all;
}

}  // namespace perimpact
