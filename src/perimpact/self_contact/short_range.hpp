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
  double friction_dissipation() const { return work_[0]; }  ///< [J] taken by friction so far; never falls
  double dashpot_dissipation() const { return work_[1]; }   ///< [J] taken by the dashpots so far; never falls
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
  /// A number of each member: against its own body, and against others.
  using OwnAndOthers = std::array<fccda::AlignedVector<double>, 2>;
  /// Pairs of the last evaluation that were nearer than the weight function reaches, as two particles each, the first the lower, in order.
  struct Kept {
    std::vector<std::uint32_t> ends;  // two each
    std::vector<double> slips;        // [m] three each where there is friction
  };

  /// Eight pairs of a member, as far as places tell.
  struct Eight {
    unsigned near;                                                ///< bits of those that the weight function reaches
    alignas(64) std::array<double, fccda::byte_lanes> densities;  ///< what they add to the density
  };

  Eight eight_of(std::size_t member, const std::int32_t* others) const;
  void look_at(std::size_t member, std::span<const ContactingBody> bodies, double dt);
  PairSum add_to(std::size_t member, std::span<const ContactingBody> bodies, double dt);
  /// Adds what those of its near pairs do that are first … last - 1, all of its own body or all of others.
  void add_pairs(std::size_t member, std::size_t first, std::size_t last, std::span<const ContactingBody> bodies, double dt, Vec3d& force, PairSum& got);
  TouchForce force_of_pair(std::size_t member, std::size_t other, std::size_t whose, std::span<const ContactingBody> bodies, double dt, Vec3d& slip) const;
  void let_go(std::size_t pair, double stiffness, PairSum& got);
  double tangential_stiffness(const NearPairs::Member& i, const NearPairs::Member& j) const;
  Vec3d slip_of(std::size_t pair) const { return {slip_[0][pair], slip_[1][pair], slip_[2][pair]}; }
  void set_slip(std::size_t pair, const Vec3d& slip) {
    for (std::size_t c = 0; c < 3; ++c) slip_[c][pair] = slip[c];
  }
  void keep_pairs();
  void take_up_pairs();
  template <class T>
  T distance_of(T size_i, T size_j) const {
    return T(law_.distance_ratio) * (T(0.5) * (size_i + size_j));
  }
  template <class T>
  T weight_of(T size, T distance) const {
    const T ratio = size / distance;
    return is_plane_ ? ratio : ratio * ratio;
  }

  ShortRangeLaw law_;
  Face face_;
  bool is_plane_;
  NearPairs near_pairs_;
  std::vector<std::array<double, 2>> stiffness_;  // [N/m⁷] of each body, against itself and against others
  std::vector<double> threshold_;                 // b of each particle against its own body
  Kept kept_;
  bool is_kept_ = false;  // in kept_, not yet with the pairs

  // of the members
  VectorArray position_, velocity_;
  fccda::AlignedVector<double> size_, volume_;  // [m] Δ, [m³]
  OwnAndOthers spring_;                         // [N/m⁷] k
  OwnAndOthers density_stiffness_;              // [J] B
  OwnAndOthers pressure_;                       // [J] B o
  std::vector<double> energy_of_;               // [J] of their density
  std::vector<PairSum> pair_sums_;
  std::vector<std::uint32_t> near_count_;
  std::vector<std::size_t> first_member_;  // of each body, and their number

  // of their pairs, from first_pair() on
  fccda::AlignedVector<std::int32_t> near_;           // the other members of those that are near, without gaps
  fccda::AlignedVector<std::int32_t> near_number_;    // which of the member's pairs these are, where there is friction
  std::vector<std::uint8_t> is_near_;                 // a bit each: in the last evaluation
  std::array<fccda::AlignedVector<double>, 3> slip_;  // [m] of the tangential springs, where there is friction; 0 where none holds
  double energy_ = 0;
  std::size_t in_contact_now_ = 0;
  std::array<double, 2> work_{};  // [J] of friction and dashpots
};

}  // namespace perimpact
