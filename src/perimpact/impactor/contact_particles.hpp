/// The particles of a body as the contact library sees them: its Points interface, read in place from the body's arrays.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "perimpact/particles/advance.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Point i is slot i. Positions are those at the end of the step, the velocities led there.
class ContactParticles {
 public:
  /// `travel`: what advance() wrote for this step.
  ContactParticles(Particles& particles, std::span<const double> travel, double dt) : particles_(particles), travel_(travel), dt_(dt) {}

  std::size_t size() const { return particles_.slots(); }
  bool occupied(std::size_t slot) const { return particles_.is_occupied(slot); }
  Vec3d position_t1(std::size_t slot) const { return particles_.position.at(slot); }
  Vec3d position_t0(std::size_t slot) const { return particles_.position.at(slot) - dt_ * particles_.velocity.at(slot); }
  Vec3d velocity(std::size_t slot) const { return particles_.velocity.at(slot); }
  double mass(std::size_t slot) const { return particles_.mass(slot); }
  /// [J] what an impulse [N s] that led to the present velocity did: kick and drift pair it with the mean of this velocity and that of the step before, which
  /// is half the ways before and after it. So the work of all other forces on the way that contact added is in it (docs/theory/energy.md).
  double work_of(std::size_t slot, const Vec3d& impulse) const {
    const Vec3d kick = (dt_ / particles_.density()) * particles_.force_density.at(slot);
    return dot(impulse, particles_.velocity.at(slot) - 0.5 * (impulse / particles_.mass(slot) + kick));
  }

  std::size_t block_count() const { return travel_.size(); }
  std::size_t block_begin(std::size_t block) const { return block * travel_block; }
  std::size_t block_end(std::size_t block) const { return std::min((block + 1) * travel_block, size()); }
  double block_travel(std::size_t block) const { return travel_[block]; }

  /// The particles of a plane body stay in it: surfaces that they meet stand upright (in_plane.hpp), to rounding, which is left out here.
  void set(std::size_t slot, Vec3d position, Vec3d velocity) {
    before_.push_back({slot, particles_.position.at(slot), particles_.velocity.at(slot)});
    if (particles_.is_plane()) position.z = particles_.position.at(slot).z, velocity.z = particles_.velocity.at(slot).z;
    particles_.position.set(slot, position);
    particles_.velocity.set(slot, velocity);
  }

  /// Takes back everything that was set, and calls visit(slot) for each.
  template <class Visit>
  void undo(const Visit& visit) {
    for (auto set = before_.rbegin(); set != before_.rend(); ++set) {
      particles_.position.set(set->slot, set->position);
      particles_.velocity.set(set->slot, set->velocity);
      visit(set->slot);
    }
    before_.clear();
  }

 private:
  struct Before {
    std::size_t slot;
    Vec3d position, velocity;
  };

  Particles& particles_;
  std::span<const double> travel_;
  double dt_;
  std::vector<Before> before_;  // in the order in which they were set
};

}  // namespace perimpact
