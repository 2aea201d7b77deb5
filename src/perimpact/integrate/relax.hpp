/// Adaptive dynamic relaxation (Kilic and Madenci, Theor. Appl. Fract. Mech. 53 (2010) 194): bodies are led to a state of equilibrium by a
/// damped motion in a time of its own, with densities that make every particle as quick as any (docs/theory/relaxation.md).
///
///   v ← ((2 - c dt) v + 2 dt F/D)/(2 + c dt),    x ← x + v dt
///
///   D_i   fictitious density [kg/m³]: as the sum of the magnitudes of the particle's row of the stiffness, so that particles are equally
///         quick; all so large that the stiffest mode of the body (stiffest_mode.hpp) is stable: ω dt < 2
///   c     damping [1/s]: twice the frequency of the deflection u since the increment began, ω² = -Σ u·(F - F_0)/Σ D u² (Rayleigh), which
///         is critical for it; at most 1.9/dt
///
///   residual = |unbalanced|/(|applied| + |rounding|/tolerance),    |F| = √Σ F_i² over the particles of a body
///
/// An increment is done when the residual of every body is below the tolerance: what is out of balance is small beside loads and forces
/// that hold, or no more than rounding of positions makes. Bonds break only in such a state, all that are too long at once; then it goes on. The motion
/// on the way there has no meaning.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/state.hpp"
#include "perimpact/body/body.hpp"
#include "perimpact/boundary_conditions/boundary_conditions.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

/// How an increment ended.
struct Relaxed {
  double residual = 0;  ///< [-] the largest of any body
  long iterations = 0;
};

/// The fictitious densities of the particles of a body, by slot, for steps of dt [s]: `safety` times what is just stable.
std::vector<double> fictitious_density(const Body& body, double dt, double safety);

/// Asked before each iteration, with how far it is; false: leave off here.
using KeepRelaxing = std::function<bool(const Relaxed&)>;

class Relaxation {
 public:
  static constexpr double default_safety = 1.2;  // the stiffest mode is found to 1 %; large strains stiffen

  /// `dt` [s]: of an increment; only a scale for fictitious velocities.
  Relaxation(const RelaxSetup& setup, std::span<const Body> bodies, double dt, double safety = default_safety);

  /// Leads the bodies to equilibrium under loads and courses of that time [s]; returns the elastic energy of each [J].
  /// Nothing where it was told to leave off; the next call, of the same increment, goes on from there. Throws RunError where it takes too long.
  std::optional<std::vector<double>> relax(std::span<Body> bodies, std::span<BoundaryConditions> boundary_conditions, long increment, double time,
                                           const KeepRelaxing& keep_on);

  const Relaxed& latest() const { return latest_; }

  /// As base/state.hpp says. Empty between increments, but for flags.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    fccda::visit_flag(visit, "under_way", under_way_);
    fccda::visit_flag(visit, "measures_anew", measures_anew_);
    visit("iterations", latest_.iterations);
    for (std::size_t b = 0; b < searches_.size(); ++b) {
      auto its = fccda::under(std::to_string(b), visit);
      its("position0", searches_[b].position0);
      its("force0", searches_[b].force0);
    }
  }

 private:
  /// What the iterations of one body need.
  struct Search {
    std::vector<double> density;            // [kg/m³] D of each slot
    double rounding = 0;                    // [N]
    std::vector<double> position0, force0;  // [m] [N/m³] three of each particle, where the deflection is measured from
  };

  double residual(std::span<Body> bodies, std::span<BoundaryConditions> boundary_conditions, double time) const;
  void start(std::span<const Body> bodies);
  double damping(const Body& body, const Search& search) const;
  void move(Body& body, const Search& search) const;

  RelaxSetup setup_;
  double dt_;
  std::vector<Search> searches_;  // of each body
  Relaxed latest_;
  bool under_way_ = false;      // an increment was left off
  bool measures_anew_ = false;  // deflections are measured from where the bodies are now
};

}  // namespace perimpact
