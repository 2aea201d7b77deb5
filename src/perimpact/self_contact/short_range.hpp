/// Short-range force between particles without an intact bond: fragments of a body, and different bodies (law: self_contact/short_range_law.hpp;
/// method: docs/theory/short_range.md).
///
/// Each particle sums its pairs in the order of body and slot and writes only to itself, so that results are bitwise reproducible across
/// thread counts. Forces of a pair are equal and opposite, so that linear momentum is conserved to rounding; without friction angular momentum
/// is too, since the force is central.
///
/// In a run of several ranks each rank evaluates its own particles, and receives positions, velocities and pressures of those of others that they are near.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "perimpact/particles/shared_numbers.hpp"
#include "perimpact/self_contact/near_pairs.hpp"

namespace perimpact {

/// Short-range contact of all bodies.
class ShortRange {
 public:
  ShortRange(const ShortRangeLaw& law, std::span<const ContactingBody> bodies);

  /// Adds the short-range forces to force_density of all bodies. `dt` [s]: last step, at the current particle velocities; 0 before the first.
  void add_forces(std::span<const ContactingBody> bodies, double dt);

  double energy() const { return energy_; }                   ///< [J] of all springs, at the last evaluation
  std::size_t contacts() const { return in_contact_now_; }    ///< pairs, at the last evaluation
  double friction_dissipation() const { return work_[0]; }    ///< [J] so far; never decreases
  double dashpot_dissipation() const { return work_[1]; }     ///< [J] so far; never decreases
  bool yields() const { return !latest_pressure_.empty(); }   ///< fragments of a body are compacted beyond a pressure
  double compaction_dissipation() const { return work_[2]; }  ///< [J] dissipated by compaction so far; never decreases
  const NearPairs& near_pairs() const { return near_pairs_; }
  void forget();  ///< forces a rebuild of the pair list; does not affect results

  /// Contribution of contact to the bounds of the stable time step, for the stiffest particle of a body with the maximum number of contacts.
  struct Bound {
    double stiffness;  ///< [N/m⁶] Σ k V_j
    double damping;    ///< [N s/m⁴] Σ 2 ζ √(K m)/V_i
  };
  Bound bound(std::span<const ContactingBody> bodies, std::size_t body) const;

  /// State: density thresholds raised by bond failure and compaction, the latest pressures of bodies that are compacted, and the pairs in range with their
  /// tangential springs.
  template <class Visitor>
  void visit_state(std::span<const ContactingBody> bodies, Visitor&& visit) {
    keep_pairs();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const std::string body = std::to_string(b);
      visit(body + ".threshold", EightNumbers(std::span<double>(threshold_[b]), bodies[b].particles));
      if (yields()) visit(body + ".latest_pressure", EightNumbers(std::span<double>(latest_pressure_[b]), bodies[b].particles));
    }
    visit("pair_ends", kept_.ends);
    visit("pair_slips", kept_.slips);
    discard_pairs_of_others();
    near_pairs_.forget();
  }

  /// Accumulated dissipation; it does not affect any step.
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    visit("work", std::span<double>(work_));
  }

 private:
  /// Sums over the pairs of a member, other than its force density; all of them doubles, for exact_sum_over_eights().
  struct PairSum {
    double energy = 0, friction_dissipation = 0, damped_work = 0;  // [J] half of each pair's
    double compaction = 0;                                         // [J]
    double contacts = 0;                                           // pairs

    PairSum& operator+=(const PairSum& other) {
      energy += other.energy, friction_dissipation += other.friction_dissipation, damped_work += other.damped_work;
      compaction += other.compaction, contacts += other.contacts;
      return *this;
    }
  };
  /// One value per member for contact with its own body, and one for contact with others.
  using OwnAndOthers = std::array<fccda::AlignedVector<double>, 2>;
  /// Pairs of the last evaluation within the support of the weight function, as ids of two particles each, lower id first, in order. Those whose first
  /// particle belongs to this rank.
  struct Kept {
    std::vector<std::uint64_t> ends;  // two each
    std::vector<double> slips;        // [m] three each where there is friction

    std::size_t size() const { return ends.size() / 2; }
    Vec3d slip(std::size_t pair) const { return slips.empty() ? Vec3d{} : Vec3d{slips[3 * pair], slips[3 * pair + 1], slips[3 * pair + 2]}; }
  };
  /// A pair on its way to the rank of its second particle.
  struct SentPair {
    std::array<std::uint64_t, 2> ends;
    Vec3d slip;
  };

  // rows of four numbers, for gather_rows()
  struct Place {
    Vec3d position;  // [m]
    double size;     // [m] Δ
  };
  struct Motion {
    Vec3d velocity;  // [m/s]
    double volume;   // [m³]
  };
  /// Eight pairs of a member, from positions alone.
  struct Eight {
    unsigned near;                                                ///< bits of those within the support of the weight function
    alignas(64) std::array<double, fccda::byte_lanes> densities;  ///< their contributions to the density; of others undefined
  };

  class SlipsInRange;

  Eight eight_of(std::size_t member, const std::int32_t* others) const;
  void evaluate(std::size_t member, std::span<const ContactingBody> bodies, double dt);
  PairSum add_to(std::size_t member, std::span<const ContactingBody> bodies, double dt);
  /// Adds the contributions of its near pairs first … last - 1, all with its own body (`whose` 0) or all with others (1).
  void add_pairs(std::size_t member, std::size_t first, std::size_t last, std::size_t whose, std::span<const ContactingBody> bodies, double dt, Vec3d& force,
                 PairSum& got);
  ParticleContactForce force_of_pair(std::size_t member, std::size_t other, std::size_t whose, std::span<const ContactingBody> bodies, double dt,
                                     Vec3d& slip) const;
  void insert_pair(std::size_t at, std::size_t last);
  void release_contact(std::size_t pair, double stiffness, PairSum& got);
  double tangential_stiffness(const NearPairs::Member& i, const NearPairs::Member& j) const;
  Vec3d slip_of(std::size_t pair) const { return {slip_[0][pair], slip_[1][pair], slip_[2][pair]}; }
  void set_slip(std::size_t pair, const Vec3d& slip) {
    for (std::size_t c = 0; c < 3; ++c) slip_[c][pair] = slip[c];
  }
  double& threshold_of(const NearPairs::Member& i) { return threshold_[i.body][i.slot]; }
  void keep_pairs();
  void discard_pairs_of_others();
  void rebuild_derived_pairs();
  void reset_particles_out_of_range();
  void restore_pairs();
  template <class F>
  void for_each_near(std::size_t member, const F& f) const;
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
  std::vector<std::array<double, 2>> stiffness_;                  // [N/m⁷] of each body, for contact with itself and with others
  std::vector<double> yield_pressure_;                            // [Pa] of each body
  std::vector<std::vector<double>> threshold_, latest_pressure_;  // b of each body and slot for contact with its own body; [J] B o, if one body yields
  Kept kept_;
  bool is_kept_ = false;  // stored in kept_, not yet assigned to pairs

  // of the members
  fccda::AlignedVector<Place> places_;
  fccda::AlignedVector<Motion> motions_;
  OwnAndOthers spring_;                  // [N/m⁷] k
  OwnAndOthers density_stiffness_;       // [J] B
  OwnAndOthers pressure_;                // [J] B o
  std::vector<double> largest_overlap_;  // [-] o at which its own body yields
  std::vector<double> energy_of_;        // [J] of their density
  std::vector<double> compaction_of_;    // [J] in the last step
  std::vector<PairSum> pair_sums_;
  std::vector<std::uint32_t> near_count_;
  std::vector<std::uint8_t> may_slip_;     // a tangential spring may be extended: with friction, after contact in the last evaluation
  std::vector<std::size_t> first_member_;  // of each body, and their number

  // of their pairs, from first_pair() on
  fccda::AlignedVector<std::int32_t> near_;           // the other members of the pairs in range, contiguous
  std::array<fccda::AlignedVector<double>, 3> slip_;  // [m] extensions of their tangential springs, in the same places; with friction only, 0 out of contact
  std::vector<std::uint8_t> is_near_;                 // one bit per pair, of the last evaluation
  double energy_ = 0;
  std::size_t in_contact_now_ = 0;
  std::array<double, 3> work_{};  // [J] of friction, dashpots and compaction
};

}  // namespace perimpact
