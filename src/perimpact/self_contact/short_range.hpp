/// Short-range force between particles without an intact bond: fragments of a body, and different bodies (force/short_range_law.hpp has the law,
/// docs/theory/short_range.md the method).
///
/// Each particle sums its own pairs in the order of body and slot and writes itself only, so that results are the same to the last bit for any
/// number of threads. What one particle gets is the opposite of what the other gets, so linear momentum is kept to rounding; angular
/// momentum too without friction, since the force is central.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "perimpact/self_contact/near_pairs.hpp"

namespace perimpact {

class ShortRange {
 public:
  ShortRange(const ShortRangeLaw& law, std::span<const ContactingBody> bodies);

  /// Adds to force_density of all bodies. `dt` [s]: of the step that led here at the velocities that particles have, 0 before the first.
  void add_forces(std::span<const ContactingBody> bodies, double dt);

  double energy() const { return energy_; }                 ///< [J] of all springs, at the last evaluation
  std::size_t touching() const { return in_contact_now_; }  ///< pairs, at the last evaluation
  double friction_dissipation() const { return work_[0]; }         ///< [J] taken by friction so far; never falls
  double dashpot_dissipation() const { return work_[1]; }      ///< [J] taken by the dashpots so far; never falls
  const NearPairs& near_pairs() const { return near_pairs_; }
  void forget();  ///< has the pairs looked for anew; changes no result

  /// What contact adds to the bounds of a stable step, for the stiffest particle of a body that has as many neighbours as can touch.
  struct Bound {
    double stiffness;  ///< [N/m⁶] Σ k V_j
    double damping;    ///< [N s/m⁴] Σ 2 ζ √(K m)/V_i
  };
  Bound bound(std::span<const ContactingBody> bodies, std::size_t body) const;

  /// Thresholds of density that bonds have left behind, and the pairs that were near with their tangential springs.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    keep_pairs();
    visit("threshold", std::span<double>(threshold_));
    visit("pair_ends", kept_.ends);
    visit("pair_slips", kept_.slips);
    near_pairs_.forget();
  }

  /// What was noted of the run so far; no step depends on it.
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    visit("work", std::span<double>(work_));
  }

 private:
  /// What a member gets, beside its force density.
  struct PairSum {
    double energy = 0, friction_dissipation = 0, damped_work = 0;  // [J] its halves of those of its pairs
    std::uint32_t touching = 0;
  };
  /// Where a member's pairs push with: B o [J] against its own body and against others.
  struct Pressure {
    double own = 0, others = 0;
  };
  /// Pairs of the last evaluation that were nearer than the weight function reaches, as two particles each, the first the lower, in order.
  struct Kept {
    std::vector<std::uint32_t> ends;  // two each
    std::vector<double> slips;        // [m] three each where there is friction
  };

  void look_at(std::size_t member, std::span<const ContactingBody> bodies, double dt);
  PairSum add_to(std::size_t member, std::span<const ContactingBody> bodies, double dt);
  double tangential_stiffness(const NearPairs::Member& i, const NearPairs::Member& j) const;
  void keep_pairs();
  void take_up_pairs();
  double weight_of(double size, double distance) const { return is_plane_ ? size / distance : (size / distance) * (size / distance); }

  ShortRangeLaw law_;
  Face face_;
  bool is_plane_;
  NearPairs near_pairs_;
  std::vector<std::array<double, 2>> stiffness_;  // [N/m⁷] of each body, against itself and against others
  std::vector<double> threshold_;                 // b of each particle against its own body
  Kept kept_;
  bool is_kept_ = false;  // in kept_, not yet with the pairs

  VectorArray position_, velocity_;  // of the members
  std::vector<Pressure> pressure_;   // of the members
  std::vector<double> energy_of_;    // [J] of the members' density
  std::vector<PairSum> pair_sums_;   // of the members
  std::vector<std::uint32_t> near_;  // of each member, from its first pair on: its pairs that are near
  std::vector<std::uint32_t> near_count_;
  std::vector<std::uint32_t> seen_;  // of each pair: the evaluation in which it was last near
  std::vector<Vec3d> slip_;          // [m] of each pair, where there is friction
  std::uint32_t evaluation_ = 1;
  double energy_ = 0;
  std::size_t in_contact_now_ = 0;
  std::array<double, 2> work_{};  // [J] of friction and dashpots
};

}  // namespace perimpact
