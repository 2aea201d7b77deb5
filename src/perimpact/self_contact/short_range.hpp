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
#include "perimpact/self_contact/short_range_view.hpp"

namespace perimpact {

/// Short-range contact of all bodies.
class ShortRange {
 public:
  ShortRange(const ShortRangeLaw& law, std::span<const ContactingBody> bodies);

  /// Adds the short-range forces to force_density of all bodies. `dt` [s]: last step, at the current particle velocities; 0 before the first.
  void add_forces(std::span<const ContactingBody> bodies, double dt);
  /// From now on evaluates one pair at a time: for tests and as the reference for devices.
  void use_scalar_kernel() { is_scalar_ = true; }

  double energy() const { return energy_; }                        ///< [J] of all springs, at the last evaluation
  std::size_t contacts() const { return in_contact_now_; }         ///< pairs, at the last evaluation
  double friction_dissipation() const { return work_[0]; }         ///< [J] so far; never decreases
  double dashpot_dissipation() const { return work_[1]; }          ///< [J] so far; never decreases
  bool yields() const { return !kept_.latest_pressures.empty(); }  ///< fragments of a body are compacted beyond a pressure
  double compaction_dissipation() const { return work_[2]; }       ///< [J] dissipated by compaction so far; never decreases
  const NearPairs& near_pairs() const { return near_pairs_; }
  void forget();                              ///< forces a rebuild of the pair list; does not affect results
  void renew_list() { near_pairs_.renew(); }  ///< the same without the particles that have been crushed

  // for a device, which evaluates what add_forces() does between new lists (device/short_range_on_device.hpp)
  NearPairs& near_pairs() { return near_pairs_; }
  void make_list(std::span<const ContactingBody> bodies);   ///< a new list
  void reserve_all_pairs() { reserves_all_pairs_ = true; }  ///< of further lists, so that insert_broken_pairs() never lacks room
  ShortRangeView view(double dt);
  void enter(const PairSum& sum);  ///< of all members, in this step
  /// Calls visit(span) for the arrays of view(), which are renewed by make_list().
  template <class Visit>
  void visit_arrays(const Visit& visit) {
    near_pairs_.visit_arrays(visit);
    visit(std::span(body_)), visit(std::span(first_member_)), visit(std::span(mass_density_)), visit(std::span(places_)), visit(std::span(motions_));
    for (OwnAndOthers* two : {&spring_, &density_stiffness_, &pressure_})
      for (auto& numbers : *two) visit(std::span(numbers));
    visit(std::span(largest_overlap_)), visit(std::span(energy_of_)), visit(std::span(compaction_of_));
    visit_state_of_members(visit);
    visit(std::span(first_near_)), visit(std::span(near_room_)), visit(std::span(near_));
  }
  /// The same for those that the steps since the last list have changed and a new list or the state needs.
  template <class Visit>
  void visit_changed_arrays(const Visit& visit) {
    const PairsView pairs = near_pairs_.view();
    visit(std::span(pairs.unbonded_counts, near_pairs_.members().size())), visit(std::span(pairs.others, near_pairs_.pair_count()));
    visit_state_of_members(visit);
  }

  /// Contribution of contact to the bounds of the stable time step, for the stiffest particle of a body with the maximum number of contacts.
  struct Bound {
    double stiffness;  ///< [N/m⁶] Σ k V_j
    double damping;    ///< [N s/m⁴] Σ 2 ζ √(K m)/V_i
  };
  std::vector<Bound> bounds(std::span<const ContactingBody> bodies) const;  ///< of each body; collective

  /// State: density thresholds raised by bond failure and compaction, the latest pressures of bodies that are compacted, and the pairs in range with their
  /// tangential springs.
  template <class Visitor>
  void visit_state(std::span<const ContactingBody> bodies, Visitor&& visit) {
    keep_state();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const std::string body = std::to_string(b);
      visit(body + ".threshold", EightNumbers(std::span<double>(kept_.thresholds[b]), bodies[b].particles));
      if (yields()) visit(body + ".latest_pressure", EightNumbers(std::span<double>(kept_.latest_pressures[b]), bodies[b].particles));
    }
    visit("pair_ends", EndsOfPairs(kept_.ends));
    visit("pair_slips", NumbersOfPairs(kept_.slips));
    discard_pairs_of_others();
    near_pairs_.forget();
  }

  /// Accumulated dissipation; it does not affect any step.
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    visit("work", std::span<double>(work_));
  }

 private:
  /// One value per member for contact with its own body, and one for contact with others.
  using OwnAndOthers = std::array<fccda::AlignedVector<double>, 2>;
  /// The state, which does not depend on the list.
  struct Kept {
    std::vector<std::vector<double>> thresholds, latest_pressures;  // b of each body and slot for contact with its own body; [J] B o, if one body yields
    // Pairs of the last evaluation within the support of the weight function, as ids of two particles each, lower id first, in order. Those whose first
    // particle belongs to this rank.
    std::vector<std::uint64_t> ends;  // two each
    std::vector<double> slips;        // [m] three each where there is friction

    std::size_t pairs() const { return ends.size() / 2; }
    Vec3d slip(std::size_t pair) const { return slips.empty() ? Vec3d{} : Vec3d{slips[3 * pair], slips[3 * pair + 1], slips[3 * pair + 2]}; }
  };
  /// A pair on its way to the rank of its second particle.
  struct SentPair {
    std::array<std::uint64_t, 2> ends;
    Vec3d slip;
  };

  void insert_broken_pairs(std::span<const ContactingBody> bodies);
  void give_room(std::span<const std::size_t> members);
  template <class Pack>
  void evaluate(std::span<const ContactingBody> bodies, double dt);
  template <class Visit>
  void visit_state_of_members(const Visit& visit) {
    visit(std::span(threshold_)), visit(std::span(latest_pressure_)), visit(std::span(near_count_)), visit(std::span(may_slip_));
    for (auto& component : slip_) visit(std::span(component));
    visit(std::span(is_near_));
  }
  void keep_state();
  void keep_pairs();
  void discard_pairs_of_others();
  void derive_constants();
  void restore_state();
  void restore_pairs();
  template <class F>
  void for_each_near(std::size_t member, const F& f) const;

  ShortRangeLaw law_;
  Face face_;
  bool is_plane_, is_scalar_ = false, reserves_all_pairs_ = false;
  NearPairs near_pairs_;
  std::vector<std::array<double, 2>> stiffness_;  // [N/m⁷] of each body, for contact with itself and with others
  std::vector<double> yield_pressure_;            // [Pa] of each body
  Kept kept_;
  bool is_kept_ = true;  // the state is in kept_, and not in the arrays below

  // of the members, as in ShortRangeView, and where they are
  std::vector<std::uint32_t> body_, slot_;
  std::vector<std::uint64_t> eight_;
  std::vector<std::size_t> first_member_;
  std::vector<double> mass_density_;
  fccda::AlignedVector<PlaceOfMember> places_;
  fccda::AlignedVector<MotionOfMember> motions_;
  OwnAndOthers spring_, density_stiffness_, pressure_;
  std::vector<double> largest_overlap_, threshold_, latest_pressure_, energy_of_, compaction_of_;
  std::vector<std::uint8_t> may_be_loaded_;  // in the latest evaluation; the others have no forces
  std::vector<PairSum> pair_sums_;           // of these
  std::vector<std::uint32_t> near_count_;
  std::vector<std::uint8_t> may_slip_;

  // of their pairs
  std::vector<std::size_t> first_near_;
  std::vector<std::uint32_t> near_room_;
  fccda::AlignedVector<std::int32_t> near_;
  std::array<fccda::AlignedVector<double>, 3> slip_;  // with friction only, 0 out of contact
  fccda::AlignedVector<std::uint8_t> is_near_;

  double energy_ = 0;
  std::size_t in_contact_now_ = 0;
  std::array<double, 3> work_{};  // [J] of friction, dashpots and compaction
};

}  // namespace perimpact
