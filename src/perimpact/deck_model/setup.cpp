#include "perimpact/deck_model/setup.hpp"

#include <algorithm>

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
                                  "10, as for ice. It is evaluated only for bonds that exceed their limit at rest."},
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
      {"mass_scaling", &S::mass_scaling, "1", at_least(1), optional,
       "Factor of the inertia of all particles, not of their weight, for quasi-static processes: the stable time step grows with its square root, and kinetic "
       "energy and momentum are those of the scaled mass. Reported masses are those of the material."},
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

std::span<const Field<MovingWindowSetup>> MovingWindowSetup::fields() {
  using S = MovingWindowSetup;
  static const Field<S> all[] = {
      {"follow", &S::follow, "", {}, required, "Name of the impactor that the body follows."},
      {"axis", &S::axis, "", {}, optional, "x or y: the direction in which the impactor travels, either way."},
      {"start_after", &S::start_after, "m", at_least(0), optional,
       "Travel of the impactor along the axis before the window follows it. From then on the window moves by multiples of eight spacings, at rows of "
       "history.csv, so that it falls behind by less than eight spacings and the travel between two rows."}};
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
      {"crushing_pressure", &S::crushing_pressure, "Pa", positive(), optional,
       "Pressure at which impactors crush the material, such as the compressive strength of ice: with radius_ratio: 0.5 the work of crushing "
       "a particle is this pressure times its volume, and the force on it at most 1.5 times the pressure on its face. A particle that is crushed "
       "loses its bonds, also those of failure.no_fail, and its contact with other particles. Rigid contact where absent."},
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
      {"frame_format",
       &S::frame_format,
       "",
       {},
       optional,
       "vtp: a file for each frame and a .pvd list, read by any ParaView. vtkhdf: one file for each body and impactor, read by ParaView 5.12 and later."},
      {"frame_fields",
       &S::frame_fields,
       "",
       {},
       optional,
       "Fields of the particles in frames, where the body has them: displacement, velocity, damage, plastic_strain, fragment, original (the number in the file "
       "of particles). Positions are always written.",
       frame_field_words},
      {"history_interval", &S::history_interval, "s", positive(), optional, "Time between rows of history.csv. Where absent, a hundredth of the run."},
      {"checkpoint_interval", &S::checkpoint_interval, "s", at_least(0), optional,
       "Wall-clock time between checkpoints, from which a stopped run can be restarted (perimpact run DECK --resume). One is always written before the last "
       "step and when the run is interrupted; 0: no others."},
      {"checkpoints_kept", &S::checkpoints_kept, "1", between(1, 100), optional,
       "Number of checkpoints kept: checkpoint.h5, the latest, and checkpoint_1.h5, … before it. A restart takes the newest that is readable."}};
  return all;
}

bool OutputSetup::writes(std::string_view field) const { return std::find(frame_fields.begin(), frame_fields.end(), field) != frame_fields.end(); }

std::span<const Field<Setup>> Setup::fields() {
  static const Field<Setup> all[] = {{"title", &Setup::title, "", {}, optional, "One line that describes the simulation."}};
  return all;
}

}  // namespace perimpact
