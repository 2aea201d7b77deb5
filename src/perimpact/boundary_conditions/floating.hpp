/// Weight and still water, of which a body may hold some under its surface: the boundary `floating`.
///
///   F_z/V = -ρ g + ρ_w g S(z),   S = clamp((z_w - z)/Δ + 1/2, 0, 1)                  [N/m³]
///   F/V   = -ρ (α + α_d) v,      α_d = ½ ρ_w C_d Δ² S |v|/(ρ V)                       [N/m³], C_d of particles at the surface alone
///   a_z   = F_z/(m + C_a ρ_w S V)                                                     [m/s²]
///
/// S is the share of a particle's height Δ (the edge of a cube of its volume) that is below the level z_w. In an intact sheet of which the level
/// stays inside, the sum over a column is Winkler's foundation of the modulus ρ_w g, exactly; a loose particle or fragment floats freely. α is
/// a damping of all velocities; water that is displaced and comes along weighs C_a times what it would fill. Buoyancy and weight have the
/// potential U = V (ρ g z + ρ_w g Δ q(t)), t = (z_w - z)/Δ + 1/2, q = 0, t²/2, t - 1/2 for t below 0, up to 1, above; their work is
/// its decrease. Docs: docs/theory/floating_bodies.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/boundary_conditions/damped.hpp"
#include "perimpact/boundary_conditions/reaction_ledger.hpp"
#include "perimpact/boundary_conditions/slot_sum.hpp"
#include "perimpact/family/exposure.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Still water, and what it does to what moves in it.
struct Water {
  double level;       ///< [m] z of its surface
  double density;     ///< [kg/m³]
  double gravity;     ///< [m/s²] along -z
  double drag;        ///< [-] C_d
  double added_mass;  ///< [-] C_a
  double damping;     ///< [1/s] α

  /// Share of a particle of that height [m] at z [m] that is under water.
  double submerged(double z, double height) const { return std::clamp((level - z) / height + 0.5, 0.0, 1.0); }
};

/// The level [m] at which the particles would float where they are now: that of no resultant force. Nothing where they are heavier than water.
std::optional<double> floating_level(const Particles& particles, std::span<const std::uint32_t> slots, const Water& water);

class Floating {
 public:
  /// `floats_at` [m]: floating_level() of the slots, not a number where they sink.
  Floating(std::vector<std::uint32_t> slots, const Water& water, double floats_at);

  std::span<const std::uint32_t> slots() const { return slots_; }
  const Water& water() const { return water_; }
  double floats_at() const { return floats_at_; }  ///< [m] the level at which it would be at rest as it was placed; not a number where it sinks

  /// A direction in which particles are held has no velocity to lose, and no inertia. `held` ascending.
  void leave_out(std::span<const std::uint32_t> held, std::size_t axis);

  /// Takes up which particles are at the body's surface now. Only where there is drag need it be called.
  void update_exposed_surface(const Particles& particles, const Family& family, std::span<const std::size_t> broken_ends);

  /// Adds weight and buoyancy to the force densities, and takes up their work and power.
  ForceSum add_to(Particles& particles);

  /// Drag, damping and added mass for the coming step of dt [s], after all other forces but those that hold. Returns the force [N].
  Vec3d resist(Particles& particles, double dt);

  double weight_buoyancy_work() const { return weight_buoyancy_work_; }  ///< [J] done on the body so far
  double drag_work() const { return drag_work_; }                        ///< [J] likewise, of drag, damping and added mass

  /// Heard of both: the force on the body at this instant, and the sum of the two works.
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
  std::optional<Exposure> exposure_;
  ForcesOnTheWay forces_;                            // of drag, damping and added mass; of no particle where there is none of them
  double potential_ = 0;                             // [J] at the latest instant
  bool has_begun_ = false;                           // potential_ is known
  double weight_buoyancy_work_ = 0, drag_work_ = 0;  // [J]
};

}  // namespace perimpact
