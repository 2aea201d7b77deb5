/// Absorbing layer at the end of a body, which damps outgoing waves: the boundary condition `absorbing`.
///
///   ρ a = F/V - ρ α v,      α = α_L (s/L)²,      α_L = 3 c ln(1/R)/L        [1/s]
///
/// s is the distance from the layer's inner side, L its thickness, c the P-wave speed √((κ + 4µ/3)/ρ). A plane wave at normal incidence decays
/// by exp(-∫ α/(2c) ds), if α is small compared with its frequency; after reflection at the free end, the share R of its amplitude remains.
/// Profile and reflection coefficient R follow Collino and Tsogka (Geophysics 66 (2001) 294), with α/2 in place of their damping, because
/// only the velocity is damped here, not the strain.
///
/// The damping is implicit in the velocity (damped.hpp), so that it does not limit the time step.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "perimpact/boundary_conditions/absorbing/absorbing_kernel.hpp"
#include "perimpact/boundary_conditions/actions/damped.hpp"
#include "perimpact/boundary_conditions/actions/listed_eights.hpp"
#include "perimpact/boundary_conditions/actions/reaction_ledger.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// α [1/s] at the depth `depth` in a layer of the thickness `thickness` [m].
double layer_damping(double depth, double thickness, double wave_speed, double reflection);

class Absorbing {
 public:
  /// `damping`: α [1/s] of each slot.
  Absorbing(std::vector<std::uint32_t> slots, std::span<const double> damping);

  std::span<const std::uint32_t> slots() const { return slots_; }
  Vec3d damping(std::size_t k) const;  ///< [1/s] of the slot with the number k, along x, y and z

  /// Excludes constrained directions from damping. `constrained` ascending.
  void leave_out(std::span<const std::uint32_t> constrained, std::size_t axis);

  /// Damps the force densities for the next step of dt [s], after all other forces except constraints. Records force and work.
  void damp(Particles& particles, double dt);

  /// For kernels elsewhere: what they read and write, and what they find.
  AbsorbingView view(Particles& particles, double dt);
  void record(const Resistance& sum);
  const ListedEights& eights() const { return eights_; }
  /// Calls visit(span) for each array of the view but those of particles.
  template <class Visit>
  void visit_arrays(const Visit& visit) {
    eights_.visit_arrays(visit);
    for (const std::vector<double>& along : damping_) visit(std::span(along));
    visit(forces_.latest());
  }
  std::span<double> latest_forces() { return forces_.latest(); }

  template <class Setup>
  static Traffic collectives_in_step(const Setup&) {
    return reduction_of_sums<Resistance>();
  }

  ReactionLedger account;

  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    account.visit_record(name, visit);
    forces_.visit_record(name, slots_, eights_, visit);
  }

 private:
  std::vector<std::uint32_t> slots_;
  ListedEights eights_;
  std::array<std::vector<double>, 3> damping_;  // [1/s] by place, along x, y and z
  ForcesOnTheWay forces_;
};

}  // namespace perimpact
