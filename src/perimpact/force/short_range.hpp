/// Short-range force between particles without an intact bond: fragments of a body, and different bodies (force/short_range_law.hpp has the law,
/// docs/theory/short_range.md the method).
///
/// Each particle sums its own pairs in the order of body and slot and writes itself only, so that results are the same to the last bit for any
/// number of threads. What one particle gets is the opposite of what the other gets, so linear momentum is kept to rounding; angular
/// momentum too without friction, since the force is central.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "perimpact/force/near_pairs.hpp"

namespace perimpact {

class ShortRange {
 public:
  ShortRange(const ShortRangeLaw& law, std::span<const TouchingBody> bodies);

  /// Adds to force_density of all bodies. The law takes the velocities as they are, half a step old; `dt` [s] bounds friction.
  void add_forces(std::span<const TouchingBody> bodies, double dt);

  /// Once force_density holds all forces: notes what friction and dashpots take in the step dt [s] that follows, from v to v + f dt/ρ, at their mean.
  void note_work(std::span<const TouchingBody> bodies, double dt);

  double energy() const { return energy_; }             ///< [J] of the springs, at the last evaluation
  std::size_t touching() const { return touching_; }    ///< pairs, at the last evaluation
  double friction_work() const { return work_[0]; }     ///< [J] taken by friction so far
  double restitution_work() const { return work_[1]; }  ///< [J] taken by the dashpots so far
  const NearPairs& near_pairs() const { return near_pairs_; }
  void forget() { near_pairs_.forget(); }  ///< has the pairs looked for anew; changes no result

  /// What contact adds to the bounds of a stable step, for the stiffest particle of a body that has as many neighbours as can touch.
  struct Bound {
    double stiffness;  ///< [N/m⁶] Σ k V_j
    double damping;    ///< [N s/m⁴] Σ 2 ζ √(K m)/V_i
  };
  Bound bound(std::span<const TouchingBody> bodies, std::size_t body) const;

  /// What was noted of the run so far; no step depends on it.
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    visit("work", std::span<double>(work_));
  }

 private:
  /// What a member gets, beside its force density.
  struct Got {
    Vec3d friction{}, dashpot{};  // [N]
    double energy = 0;            // [J] its half of the springs'
    std::uint32_t touching = 0;
  };
  Got add_to(std::size_t member, std::span<const TouchingBody> bodies, double dt) const;

  ShortRangeLaw law_;
  NearPairs near_pairs_;
  VectorArray position_, velocity_;  // of the members
  std::vector<Got> got_;             // of the members
  double energy_ = 0;
  std::size_t touching_ = 0;
  std::array<double, 2> work_{};  // [J] of friction and dashpots
};

}  // namespace perimpact
