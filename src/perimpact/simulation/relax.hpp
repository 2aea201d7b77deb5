/// Adaptive dynamic relaxation (Kilic and Madenci, Theor. Appl. Fract. Mech. 53 (2010) 194): bodies are led to a state of equilibrium by a
/// damped motion in a time of its own, with densities that make every particle as quick as any (docs/theory/relaxation.md).
///
///   v ← ((2 - c dt) v + 2 dt F/D)/(2 + c dt),    x ← x + v dt
///
///   D_i   fictitious density [kg/m³]: as the sum of the magnitudes of the particle's row of the stiffness, so that particles are equally
///         quick; all so large that the highest frequency of the body, found by power iteration, is stable: ω dt < 2
///   c     damping [1/s]: twice the frequency of the deflection u since the increment began, ω² = -Σ u·(F - F_0)/Σ D u² (Rayleigh), which
///         is critical for it; at most 1.9/dt
///
///   residual = |unbalanced|/(|applied| + |rounding|/tolerance),    |F| = √Σ F_i² over the particles of a body
///
/// An increment is done when the residual of every body is below the tolerance: what is out of balance is small beside loads and forces
/// that hold, or no more than rounding of positions makes. Bonds break only in such a state, all that are too long at once; then it goes on. The motion
/// on the way there has no meaning.
#pragma once

#include <span>
#include <vector>

#include "perimpact/boundary/boundaries.hpp"
#include "perimpact/setup/setup.hpp"
#include "perimpact/simulation/body.hpp"

namespace perimpact {

/// How an increment ended.
struct Relaxed {
  double residual = 0;  ///< [-] the largest of any body
  long iterations = 0;
};

/// The fictitious densities of the particles of a body, by slot, for steps of dt [s]: `safety` times what is just stable for the body as it
/// is now. Leaves the body as it is, but for its force densities.
std::vector<double> fictitious_density(Body& body, double dt, double safety);

class Relaxation {
 public:
  static constexpr double usual_safety = 1.25;  // the power iteration ends a few parts in a hundred too low; large strains stiffen

  /// `dt` [s]: of an increment; only a scale for fictitious velocities.
  Relaxation(const RelaxSetup& setup, std::span<Body> bodies, double dt, double safety = usual_safety);

  /// Leads the bodies to equilibrium under loads and courses of that time [s]; returns the elastic energy of each [J].
  /// Throws RunError where it takes too long.
  std::vector<double> relax(std::span<Body> bodies, std::span<Boundaries> boundaries, long increment, double time);

  const Relaxed& latest() const { return latest_; }

 private:
  /// What the iterations of one body need.
  struct Search {
    std::vector<double> density;           // [kg/m³] D of each slot
    double rounding = 0;                   // [N]
    std::vector<Vec3d> position0, force0;  // [m] [N/m³] of each particle where the deflection is measured from
  };

  double residual(std::span<Body> bodies, std::span<Boundaries> boundaries, double time) const;
  void start(std::span<const Body> bodies);
  double damping(const Body& body, const Search& search) const;
  void move(Body& body, const Search& search) const;

  RelaxSetup setup_;
  double dt_;
  std::vector<Search> searches_;  // of each body
  Relaxed latest_;
};

}  // namespace perimpact
