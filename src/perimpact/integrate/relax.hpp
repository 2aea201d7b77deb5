/// Adaptive dynamic relaxation (Kilic and Madenci, Theor. Appl. Fract. Mech. 53 (2010) 194): bodies converge to equilibrium by a
/// damped motion in pseudo-time, with fictitious densities that equalise particle frequencies (docs/theory/relaxation.md).
///
///   v ← ((2 - c dt) v + 2 dt F/D)/(2 + c dt),    x ← x + v dt
///
///   D_i   fictitious density [kg/m³]: proportional to the absolute row sum of the stiffness, so that particle frequencies are equal;
///         scaled such that the stiffest mode of the body (stiffest_mode.hpp) is stable: ω dt < 2
///   c     damping [1/s]: critical damping, twice the frequency of the displacement u since the start of the increment,
///         ω² = -Σ u·(F - F_0)/Σ D u² (Rayleigh quotient); at most 1.9/dt
///
///   residual = |unbalanced|/(|applied| + |rounding|/tolerance),    |F| = √Σ F_i² over the particles of a body
///
/// An increment has converged when the residual of every body is below the tolerance: unbalanced forces are small relative to loads and
/// reactions, or at rounding level. Bonds break only in such a state, all beyond the critical stretch at once; iterations then continue. The
/// transient motion has no physical meaning.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/state.hpp"
#include "perimpact/body/body.hpp"
#include "perimpact/boundary_conditions/boundary_conditions.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/particles/shared_numbers.hpp"

namespace perimpact {

/// Convergence of an increment.
struct Relaxed {
  double residual = 0;  ///< [-] the largest of any body
  long iterations = 0;
};

/// The fictitious densities of the particles of a body, by slot, for steps of dt [s]: `safety` times the stability limit.
std::vector<double> fictitious_density(const Body& body, double dt, double safety);

/// Called before each iteration with the progress; false interrupts the increment.
using KeepRelaxing = std::function<bool(const Relaxed&)>;

class Relaxation {
 public:
  static constexpr double default_safety = 1.2;  // the stiffest mode is known to 1 %; large strains stiffen

  /// `dt` [s]: of an increment; only a scale for fictitious velocities.
  Relaxation(const RelaxSetup& setup, std::span<const Body> bodies, double dt, double safety = default_safety);

  /// Relaxes the bodies to equilibrium under the loads and prescribed displacements of that time [s]; returns the elastic energy of each [J].
  /// Empty if interrupted; the next call, of the same increment, resumes. Throws RunError if the iterations do not converge.
  std::optional<std::vector<double>> relax(std::span<Body> bodies, std::span<BoundaryConditions> boundary_conditions, long increment, double time,
                                           const KeepRelaxing& keep_on);

  const Relaxed& latest() const { return latest_; }

  /// See base/state.hpp. Between increments only flags.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    fccda::visit_flag(visit, "under_way", under_way_);
    fccda::visit_flag(visit, "measures_anew", measures_anew_);
    visit("iterations", latest_.iterations);
    for (std::size_t b = 0; b < searches_.size(); ++b) {
      auto its = fccda::under(std::to_string(b), visit);
      Search& search = searches_[b];
      const auto list = [&](const char* name, std::vector<double>& numbers) {
        const std::span<const std::uint32_t> slots = search.particles->slot_of();
        if (under_way_) numbers.resize(3 * slots.size());  // where they are read
        ListNumbers listed(std::span<double>(numbers), slots);
        listed.share = &search.particles->share();
        its(name, listed);
      };
      list("position0", search.position0), list("force0", search.force0);
    }
  }

 private:
  /// Data for the iterations of one body.
  struct Search {
    const Particles* particles;             // of the body
    std::vector<double> density;            // [kg/m³] D of each slot
    double rounding = 0;                    // [N]
    std::vector<double> position0, force0;  // [m] [N/m³] three of each particle, reference of the displacement
  };

  double residual(std::span<Body> bodies, std::span<BoundaryConditions> boundary_conditions, double time) const;
  void start(std::span<const Body> bodies);
  double damping(const Body& body, const Search& search) const;
  void move(Body& body, const Search& search) const;

  RelaxSetup setup_;
  double dt_;
  std::vector<Search> searches_;  // of each body
  Relaxed latest_;
  bool under_way_ = false;      // an increment was interrupted
  bool measures_anew_ = false;  // displacements are measured from the current state
};

}  // namespace perimpact
