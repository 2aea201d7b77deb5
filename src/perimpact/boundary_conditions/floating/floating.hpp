/// Weight, buoyancy, drag and added mass in still water: the boundary condition `floating`.
///
///   F_z/V = -ρ g + ρ_w g S(z),   S = clamp((z_w - z)/Δ + 1/2, 0, 1)                  [N/m³]
///   F/V   = -ρ (α + α_d) v,      α_d = ½ ρ_w C_d Δ² S |v|/(ρ V)                       [N/m³], C_d of particles at the surface alone
///   a_z   = F_z/(m + C_a ρ_w S V),  or  F_z/(m + ρ_w d Δ² W (1 - φ)/n)                [m/s²]; F_z/m in contact with an impactor
///
/// S is the submerged share of a particle's height Δ (the edge of a cube of its volume) below the level z_w. In an intact sheet that contains
/// the level, the sum over a column is exactly a Winkler foundation of the modulus ρ_w g; a fragment floats freely. α is mass-proportional
/// damping; C_a is the added mass over that of the displaced water, d the depth of the water that a column entrains, n the number of its
/// particles whose vertical motion neither an impactor nor a constraint prescribes, W the largest S in it, and φ the damage of the particle. Buoyancy and
/// weight have the potential U = V (ρ g z + ρ_w g Δ q(t)), t = (z_w - z)/Δ + 1/2, q = 0, t²/2, t - 1/2 for t below 0, up to 1, above; their work is its
/// decrease. The top particle of a column whose top is dry has S = t and q = t²/2 for all t above 0. Docs: docs/theory/floating_bodies.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/boundary_conditions/actions/damped.hpp"
#include "perimpact/boundary_conditions/actions/force_sum.hpp"
#include "perimpact/boundary_conditions/actions/listed_eights.hpp"
#include "perimpact/boundary_conditions/actions/reaction_ledger.hpp"
#include "perimpact/boundary_conditions/floating/setup.hpp"
#include "perimpact/boundary_conditions/floating/water_columns.hpp"
#include "perimpact/boundary_conditions/floating/water_kernels.hpp"
#include "perimpact/family/exposure.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Equilibrium level [m] of the particles at their current positions, with zero resultant force. Empty if they are heavier than water.
std::optional<double> floating_level(const Particles& particles, std::span<const std::uint32_t> slots, const Water& water);

/// Sums of weight and buoyancy over particles.
struct Hydrostatics {
  double lift = 0;       ///< [N] along z
  double potential = 0;  ///< [J]
  double squared = 0;    ///< [N²] of the lift of each particle; 0 where it is not asked for
};

class Floating {
 public:
  /// `floats_at` [m]: floating_level() of the slots, NaN if they sink. An entrained depth and a dry top need a body on a lattice.
  Floating(const Particles& particles, std::vector<std::uint32_t> slots, const Water& water, double floats_at);

  std::span<const std::uint32_t> slots() const { return slots_; }
  const Water& water() const { return water_; }
  double floats_at() const { return floats_at_; }  ///< [m] equilibrium level at the initial position; NaN if it sinks

  /// Excludes constrained directions from damping and added mass. `constrained` ascending.
  void leave_out(std::span<const std::uint32_t> constrained, std::size_t axis);

  /// Particles in these slots, ascending, were in contact with impactors in this step: they have no added mass in it. The others of their column carry the
  /// water that it entrains.
  void exclude_from_added_mass(std::span<const std::uint32_t> in_contact);

  /// Updates exposed particles at the body's surface, and what columns lose with their bonds and by their depth.
  void update_exposed_surface(const Particles& particles, const Family& family, std::span<const std::uint32_t> broken_ends);

  /// The parts of update_exposed_surface().
  struct SurfaceChange {
    bool is_exposed = false;            ///< further particles are exposed
    std::vector<std::uint32_t> eights;  ///< of which particles have lost bonds, by their numbers in the list; with an entrained depth
    std::vector<std::uint32_t> tops;    ///< places of dry tops whose column has lost bonds
  };
  SurfaceChange update_surface(const Particles& particles, const Family& family, std::span<const std::uint32_t> broken_ends);
  void flood(std::span<const std::uint32_t> tops, const Particles& particles);

  /// Floods the columns whose top lies deeper than it stays dry.
  void flood_deep_columns(const Particles& particles);

  /// Adds weight and buoyancy to the force densities, and records their work.
  ForceSum static_hydrostatics(Particles& particles);
  void apply_hydrostatics(Particles& particles);

  /// Applies drag, damping and added mass for the next step of dt [s], after all other forces except constraints. Returns the force [N].
  Vec3d resist(Particles& particles, double dt);
  void apply_resistance(Particles& particles, double dt) { record_force(resist(particles, dt)); }

  /// For kernels elsewhere: what they read and write, and what they find.
  WaterView view(Particles& particles);
  const ListedEights& eights() const { return eights_; }
  /// Calls visit(span) for each array of the view but those of particles; a point cloud has further ones.
  template <class Visit>
  void visit_arrays(const Visit& visit) {
    eights_.visit_arrays(visit);
    if (columns_) columns_->visit_arrays(visit);
    for (const std::vector<std::uint8_t>& along : moves_) visit(std::span(along));
    visit(std::span(exposed_)), visit(std::span(in_contact_)), visit(std::span(is_dry_)), visit(std::span(intact_)), visit(std::span(wetness_)),
        visit(std::span(carriers_)), visit(forces_.latest());
  }
  std::span<double> latest_forces() { return forces_.latest(); }
  std::span<const std::uint8_t> exposed() const { return exposed_; }
  std::span<const std::uint8_t> in_contact() const { return in_contact_; }
  std::span<const double> carriers() const { return carriers_; }
  bool contact_has_changed() const { return contact_has_changed_; }  ///< in the latest exclude_from_added_mass()
  std::span<const std::uint8_t> dry_tops() const { return is_dry_; }
  std::span<const double> intact_shares() const { return intact_; }
  bool resists() const { return water_.drag != 0 || water_.damping != 0 || water_.adds_mass(); }
  void record(const Hydrostatics& sum);
  Vec3d record(const Resistance& sum);  ///< returns the force
  void record_force(const Vec3d& resistance) { account.record_force(Vec3d{0, 0, lift_z_} + resistance, {}); }
  Vec3d conjugate_displacement(const Particles&, double) const { return {}; }  ///< the work is that of a potential

  /// Other particles float than in the last step: the change of the potential until the next step is no work.
  void restart_potential() { has_begun_ = false; }

  double weight_buoyancy_work() const { return weight_buoyancy_work_; }  ///< [J] cumulative, done on the body
  double drag_work() const { return drag_work_; }                        ///< [J] cumulative, of drag, damping and added mass

  bool has_dry_top() const { return water_.dry_top != 0; }               ///< columns had a dry top at the beginning
  double flooding_dissipation() const { return flooding_dissipation_; }  ///< [J] cumulative, by water that falls on tops that were dry

  static Traffic collectives_in_step(const FloatingSetup& setup);

  /// Force on the body at this instant, and the sum of both works.
  ReactionLedger account;

  template <class Visitor>
  void visit_state(const std::string& name, Visitor&& visit) {
    if (has_dry_top())
      visit_by_slot(
          eights_.place_of(), 1, [&](std::size_t place, std::size_t) -> std::uint8_t& { return is_dry_[place]; },
          [&](std::span<std::uint8_t> numbers) { visit(name + ".dry_tops", ListNumbers(numbers, slots_)); });
    exposure_.reset();  // derived from the bonds, which may be those of another state
  }
  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    if (has_dry_top()) visit(name + ".flooding", std::span<double>(&flooding_dissipation_, 1));
    account.visit_record(name, visit);
    forces_.visit_record(name, slots_, eights_, visit);
    double all[] = {potential_, has_begun_ ? 1.0 : 0.0, weight_buoyancy_work_, drag_work_};
    visit(name + ".water", std::span<double>(all));
    potential_ = all[0], has_begun_ = all[1] != 0, weight_buoyancy_work_ = all[2], drag_work_ = all[3];
  }

 private:
  Hydrostatics lift(Particles& particles, bool with_squares);
  double flood_top(std::uint32_t top, const Particles& particles);  // [J] that the water loses
  void expose(std::size_t k);
  /// Whether the particle with the number k in the list is free along an axis.
  bool moves(std::size_t k, std::size_t axis) const { return (moves_[axis][eights_.place(k) / fccda::byte_lanes] >> (slots_[k] % fccda::byte_lanes)) & 1u; }
  void update_intact_share(const Family& family, std::span<const std::uint32_t> changed);
  void record_flooding(double loss);

  std::vector<std::uint32_t> slots_;
  ListedEights eights_;
  std::array<std::vector<std::uint8_t>, 3> moves_;  // of each eight, along x, y, z
  Water water_;
  double floats_at_;
  double lift_z_ = 0;  // [N] of weight and buoyancy, at the latest positions
  std::optional<Exposure> exposure_;
  std::vector<std::uint8_t> exposed_;             // of each eight: what exposure_ says of the particles
  std::vector<std::uint8_t> in_contact_;          // of each eight: particles in contact with impactors in this step
  std::vector<std::uint32_t> listed_in_contact_;  // the same, by their numbers in the list
  bool contact_has_changed_ = false;
  std::optional<WaterColumns> columns_;
  std::vector<double> heights_;       // [m] by slot; empty on a lattice
  std::vector<double> wetness_;       // W of each column; empty without an entrained depth
  std::vector<double> carriers_;      // of each column: its particles that neither contact nor a constraint moves; empty without an entrained depth
  std::vector<double> intact_;        // 1 - φ by place; empty without an entrained depth
  std::vector<std::uint8_t> is_dry_;  // by place, 1 for the top of a column that is dry there; empty without a dry top
  ForcesOnTheWay forces_;             // of drag, damping and added mass; empty without them
  double potential_ = 0;              // [J] at the latest instant
  bool has_begun_ = false;            // potential_ is known
  double weight_buoyancy_work_ = 0, drag_work_ = 0;  // [J]
  double flooding_dissipation_ = 0;                  // [J]
};

}  // namespace perimpact
