/// Weight, buoyancy, drag and added mass in still water: the boundary condition `floating`.
///
///   F_z/V = -ρ g + ρ_w g S(z),   S = clamp((z_w - z)/Δ + 1/2, 0, 1)                  [N/m³]
///   F/V   = -ρ (α + α_d) v,      α_d = ½ ρ_w C_d Δ² S |v|/(ρ V)                       [N/m³], C_d of particles at the surface alone
///   a_z   = F_z/(m + C_a ρ_w S V)                                                     [m/s²]
///
/// S is the submerged share of a particle's height Δ (the edge of a cube of its volume) below the level z_w. In an intact sheet that contains
/// the level, the sum over a column is exactly a Winkler foundation of the modulus ρ_w g; a fragment floats freely. α is mass-proportional
/// damping; C_a is the added mass over that of the displaced water. Buoyancy and weight have the
/// potential U = V (ρ g z + ρ_w g Δ q(t)), t = (z_w - z)/Δ + 1/2, q = 0, t²/2, t - 1/2 for t below 0, up to 1, above; their work is
/// its decrease. Docs: docs/theory/floating_bodies.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/boundary_conditions/actions/damped.hpp"
#include "perimpact/boundary_conditions/actions/reaction_ledger.hpp"
#include "perimpact/boundary_conditions/actions/slot_sum.hpp"
#include "perimpact/family/exposure.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Still water and its effect on particles.
struct Water {
  double level;       ///< [m] z of the free surface
  double density;     ///< [kg/m³]
  double gravity;     ///< [m/s²] along -z
  double drag;        ///< [-] C_d
  double added_mass;  ///< [-] C_a
  double damping;     ///< [1/s] α

  /// Submerged share of a particle of that height [m] at z [m].
  double submerged(double z, double height) const { return std::clamp((level - z) / height + 0.5, 0.0, 1.0); }
};

/// Equilibrium level [m] of the particles at their current positions, with zero resultant force. Empty if they are heavier than water.
std::optional<double> floating_level(const Particles& particles, std::span<const std::uint32_t> slots, const Water& water);

class Floating {
 public:
  /// `floats_at` [m]: floating_level() of the slots, NaN if they sink.
  Floating(std::vector<std::uint32_t> slots, const Water& water, double floats_at);

  std::span<const std::uint32_t> slots() const { return slots_; }
  const Water& water() const { return water_; }
  double floats_at() const { return floats_at_; }  ///< [m] equilibrium level at the initial position; NaN if it sinks

  /// Excludes constrained directions from damping and added mass. `held` ascending.
  void leave_out(std::span<const std::uint32_t> held, std::size_t axis);

  /// Updates exposed particles at the body's surface; needed for drag only.
  void update_exposed_surface(const Particles& particles, const Family& family, std::span<const std::size_t> broken_ends);

  /// Adds weight and buoyancy to the force densities, and records their work.
  ForceSum static_hydrostatics(Particles& particles);
  void apply_hydrostatics(Particles& particles) { lift_ = static_hydrostatics(particles).force; }

  /// Applies drag, damping and added mass for the next step of dt [s], after all other forces except constraints. Returns the force [N].
  Vec3d resist(Particles& particles, double dt);
  void apply_resistance(Particles& particles, double dt) { account.record_force(lift_ + resist(particles, dt), {}); }
  Vec3d conjugate_displacement(const Particles&, double) const { return {}; }  ///< the work is that of a potential

  double weight_buoyancy_work() const { return weight_buoyancy_work_; }  ///< [J] cumulative, done on the body
  double drag_work() const { return drag_work_; }                        ///< [J] cumulative, of drag, damping and added mass

  /// Force on the body at this instant, and the sum of both works.
  ReactionLedger account;

  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    account.visit_record(name, visit);
    forces_.visit_record(name, visit);
    double all[] = {potential_, has_begun_ ? 1.0 : 0.0, weight_buoyancy_work_, drag_work_};
    visit(name + ".water", std::span<double>(all));
    potential_ = all[0], has_begun_ = all[1] != 0, weight_buoyancy_work_ = all[2], drag_work_ = all[3];
  }

 private:
  bool resists() const { return water_.drag != 0 || water_.damping != 0 || water_.added_mass != 0; }

  std::vector<std::uint32_t> slots_;
  std::vector<std::array<bool, 3>> moves_;  // of each slot along x, y, z
  Water water_;
  double floats_at_;
  Vec3d lift_{};  // [N] of weight and buoyancy, at the latest positions
  std::optional<Exposure> exposure_;
  ForcesOnTheWay forces_;                            // of drag, damping and added mass; empty without them
  double potential_ = 0;                             // [J] at the latest instant
  bool has_begun_ = false;                           // potential_ is known
  double weight_buoyancy_work_ = 0, drag_work_ = 0;  // [J]
};

}  // namespace perimpact
