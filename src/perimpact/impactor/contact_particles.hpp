/// Adapter of a body's particles to the Points interface of the contact library, without copies.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "fccda/respond/crushing.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/particles/advance.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Point i is slot i. Positions are at the end of the step, velocities those of the step. The position of a particle that is crushed in part is that of the
/// ball that is left of it.
class ContactParticles {
 public:
  /// Brings positions, velocities and force densities of these slots to the arrays of the host.
  using Fetch = std::function<void(std::span<const std::uint32_t> slots)>;

  /// `travel`: of advance() for this step. `fetch`: of particles on a device; empty for others.
  ContactParticles(Particles& particles, const ImpactorContactSetup& contact, std::span<const double> travel, double dt, Fetch fetch = {})
      : particles_(particles),
        radius_(contact.radius_ratio * particles.spacing()),
        crushing_pressure_(contact.crushing_pressure.value_or(0)),
        travel_(travel),
        dt_(dt),
        fetch_(std::move(fetch)) {}

  bool is_remote() const { return static_cast<bool>(fetch_); }
  void fetch(std::span<const std::size_t> slots) const { fetch_(std::vector<std::uint32_t>(slots.begin(), slots.end())); }

  std::size_t size() const { return particles_.slots(); }
  bool occupied(std::size_t slot) const { return particles_.owns(slot); }
  Vec3d position_t1(std::size_t slot) const { return ball(slot, centre_t1(slot)); }
  Vec3d position_t0(std::size_t slot) const { return ball(slot, centre_t0(slot)); }
  Vec3d centre_t1(std::size_t slot) const { return particles_.position.at(slot); }  ///< [m] of the particle
  Vec3d centre_t0(std::size_t slot) const { return particles_.position.at(slot) - dt_ * particles_.velocity.at(slot); }
  Vec3d offset(std::size_t slot) const { return particles_.crushed.offset(slot); }
  Vec3d velocity(std::size_t slot) const { return particles_.velocity.at(slot); }
  double mass(std::size_t slot) const { return particles_.mass(slot); }
  double largest_radius() const { return radius_; }
  double radius(std::size_t slot) const { return radius_ - particles_.crushed.depth(slot) / 2; }
  /// The work of crushing is the pressure times the volume of the particle, if its thickness is one spacing (radius_ratio 0.5).
  fccda::Crushing crushing(std::size_t slot) const {
    const CrushedMaterial& crushed = particles_.crushed;
    if (crushed.empty()) return {};
    const double face = particles_.volume(slot) / particles_.spacing();
    return {.largest_force = 1.5 * crushing_pressure_ * face, .thickness = crushed.thickness(), .depth = crushed.depth(slot), .left = crushed.left(slot)};
  }
  bool is_crushed(std::size_t slot) const { return particles_.crushed.is_crushed(slot); }
  /// Slot in the lattice of the whole body, which ranks share.
  std::size_t whole_slot(std::size_t slot) const { return particles_.share().whole_slot(slot); }
  /// [J] work of an impulse [N s] that led to the current velocity, paired with the mean of this velocity and that of the previous step. It
  /// includes the work of all other forces on the displacement by contact (docs/theory/energy.md).
  double work_of(std::size_t slot, const Vec3d& impulse) const {
    const Vec3d kick = (dt_ / particles_.density()) * particles_.force_density.at(slot);
    return dot(impulse, particles_.velocity.at(slot) - 0.5 * (impulse / particles_.mass(slot) + kick));
  }

  std::size_t block_count() const { return travel_.size(); }
  std::size_t block_begin(std::size_t block) const { return block * travel_block; }
  std::size_t block_end(std::size_t block) const { return std::min((block + 1) * travel_block, size()); }
  double block_travel(std::size_t block) const { return travel_[block]; }

  /// Particles of a plane body stay in the plane: surfaces in contact are prismatic (in_plane.hpp); rounding along z is discarded.
  void set(std::size_t slot, Vec3d position, Vec3d velocity) {
    before_.push_back({slot, particles_.position.at(slot), particles_.velocity.at(slot), particles_.crushed.depth(slot), offset(slot)});
    position -= offset(slot);
    if (particles_.is_plane()) position.z = particles_.position.at(slot).z, velocity.z = particles_.velocity.at(slot).z;
    particles_.position.set(slot, position);
    particles_.velocity.set(slot, velocity);
  }

  void crush(std::size_t slot, double depth, const Vec3d& direction) {
    CrushedMaterial& crushed = particles_.crushed;
    crushed.set(slot, crushed.depth(slot) + depth, crushed.offset(slot) + (depth / 2) * direction);
  }

  /// Slots that differ from before contact, since the latest undo(); in the order of the changes, perhaps repeatedly.
  std::vector<std::uint32_t> changed() const {
    std::vector<std::uint32_t> slots;
    for (const Before& set : before_) slots.push_back(static_cast<std::uint32_t>(set.slot));
    return slots;
  }

  /// Reverts all changes, and calls visit(slot) for each.
  template <class Visit>
  void undo(const Visit& visit) {
    for (auto set = before_.rbegin(); set != before_.rend(); ++set) {
      particles_.position.set(set->slot, set->position);
      particles_.velocity.set(set->slot, set->velocity);
      if (!particles_.crushed.empty()) particles_.crushed.set(set->slot, set->crushed, set->offset);
      visit(set->slot);
    }
    before_.clear();
  }

 private:
  struct Before {
    std::size_t slot;
    Vec3d position, velocity;
    double crushed;  // [m] depth
    Vec3d offset;
  };

  Vec3d ball(std::size_t slot, const Vec3d& centre) const { return particles_.crushed.empty() ? centre : centre + particles_.crushed.offset(slot); }

  Particles& particles_;
  double radius_;             // [m] of particles that are not crushed
  double crushing_pressure_;  // [Pa]
  std::span<const double> travel_;
  double dt_;
  Fetch fetch_;
  std::vector<Before> before_;  // in order of the changes
};

}  // namespace perimpact
