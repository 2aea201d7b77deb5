/// Verlet list (neighbour list with a skin) of particle pairs for short-range contact. It is a cache: results do not depend on it.
///
/// A pair is in contact if its particles are nearer than their contact distance, have no intact bond, and at least one of them is exposed
/// (family/exposure.hpp). The list contains every such pair as long as
///   every displacement since the list was built is within the margin of its particle of a common drift, so that rigid translation does not invalidate the
///     list. The margin is half a skin, and more for the fastest particles (FastParticles). The list reaches as far beyond contact as the margins of both;
///   bonds broke only near particles that had lost one before, where the list contains bonded pairs too.
/// It is rebuilt in the step in which either condition fails. Surplus pairs do not affect results: pairs out of contact are skipped, and
/// those in contact are summed in the order of body and slot.
///
/// In a run of several ranks a list has the pairs of this rank's own particles. Their other ends may belong to other ranks (ForeignParticles).
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/aligned.hpp"
#include "perimpact/family/exposure.hpp"
#include "perimpact/self_contact/displacement_extremes.hpp"
#include "perimpact/self_contact/fast_particles.hpp"
#include "perimpact/self_contact/foreign_particles.hpp"
#include "perimpact/self_contact/pairs_view.hpp"
#include "perimpact/self_contact/short_range_law.hpp"
#include "perimpact/self_contact/wrapped_cells.hpp"

namespace perimpact {

/// Makes room without keeping the values: if the capacity is too small, the old array is freed first. Arrays of pairs are the largest of a run with rubble, and
/// old and new ones together would determine its peak memory. An eighth more is reserved for the next list.
template <class T, class Allocator>
void make_room(std::vector<T, Allocator>& values, std::size_t count) {
  if (values.capacity() >= count) return;
  values = std::vector<T, Allocator>();
  values.reserve(count + count / 8);
}

/// The same, and resizes.
template <class T, class Allocator>
void resize_to(std::vector<T, Allocator>& values, std::size_t count) {
  make_room(values, count);
  values.resize(count);
}

class NearPairs {
 public:
  /// A particle with pairs in the list.
  struct Member {
    std::uint32_t body : 31, is_foreign : 1;
    std::uint32_t slot;  ///< of a foreign particle: its index among these
    Vec3d reference;     ///< [m] X
    double size;         ///< [m] Δ_i
    double volume;       ///< [m³]
    std::uint64_t id;    ///< slot in the whole body, counted on over all bodies
  };
  /// What changes of a foreign particle in each step.
  struct ForeignState {
    Vec3d position, velocity;  ///< [m], [m/s]
    std::uint64_t is_exposed;
  };
  /// The possible contacts of a member, by body and slot: its pairs without an intact bond.
  struct Pairs {
    std::size_t count;
    const std::int32_t* others;  ///< members
  };

  NearPairs(const ShortRangeLaw& law, std::span<const ContactingBody> bodies);

  /// Returns whether the list is out of date; to be called once per step. make() rebuilds it. Both are collective.
  bool needs_new_list(std::span<const ContactingBody> bodies);
  /// The same, with extremes over all own particles, after use_common_skin().
  bool needs_new_list(std::span<const ContactingBody> bodies, const DisplacementExtremes& of_own);
  void use_common_skin() { has_fast_ = false; }  ///< further lists have no fast particles
  void make(std::span<const ContactingBody> bodies);
  /// Receives the state of foreign members from their owners; to be called in each step, after make(). Collective.
  void refresh_foreign(std::span<const ContactingBody> bodies);
  /// Calls set(foreign member, value) with value_of(member) of its owner; a member without pairs there has the value T{}. Collective.
  template <class T, class ValueOf, class Set>
  void refresh_members(const ValueOf& value_of, const Set& set) const;
  /// To be called where bonds or positions may have been replaced, as by a restart or the move of a window: the next step derives exposed particles from the
  /// bonds, and rebuilds the list. Counts of broken ends do not move with the material.
  void forget();
  /// To be called where particles have been crushed, which have no contact (CrushedMaterial): the next step rebuilds the list.
  void renew() { is_known_ = false; }

  /// Members of this rank in eights that had lost bonds at the last call of needs_new_list(): some of their pairs may no longer be bonded, which
  /// insert_broken_pairs() is to find before the next call. None after make().
  std::vector<std::uint32_t> members_with_broken_bonds() const;

  std::span<const Member> members() const { return members_; }  ///< by body and slot
  Pairs pairs_of(std::size_t member) const { return {unbonded_counts_[member], others_.data() + first_pair_[member]}; }
  std::size_t first_pair(std::size_t member) const { return first_pair_[member]; }  ///< index of its first pair among all pairs, a multiple of eight
  std::size_t pair_count() const { return pair_count_; }                            ///< including the padding after each member's pairs
  PairsView view() { return {first_pair_.data(), pair_counts_.data(), unbonded_counts_.data(), exposed_.data(), others_.data(), bonds_.data()}; }
  /// Calls visit(span) for the arrays of view(). They are renewed by make().
  template <class Visit>
  void visit_arrays(const Visit& visit) {
    visit(std::span(first_pair_)), visit(std::span(pair_counts_)), visit(std::span(unbonded_counts_)), visit(std::span(exposed_));
    visit(std::span(others_).first(pair_count_)), visit(std::span(bonds_).first(pair_count_));
  }
  std::span<std::uint8_t> exposed() { return exposed_; }                           ///< of each member
  std::size_t times_exposed() const { return times_exposed_; }                     ///< changes of exposed() since construction
  std::span<const Member> particles() const { return particles_; }                 ///< all of this rank, with or without pairs, and foreign ones
  const VectorArray& reference_positions() const { return reference_positions_; }  ///< [m] of particles(), when the list was built
  const Vec3d& drift() const { return drift_; }                                    ///< [m] approximate common displacement since
  const ForeignState& foreign_state(const Member& member) const { return foreign_states_[member.slot]; }
  /// The member of that id; nothing if it has no pairs here.
  std::optional<std::size_t> member_of_id(std::uint64_t id) const;
  int owner_of(std::uint64_t id) const;  ///< rank
  Ranks& ranks() const { return shares_.front().ranks(); }
  std::size_t times_made() const { return times_made_; }

 private:
  static constexpr std::uint32_t none = no_bond;

  struct Found {
    std::uint32_t particle, bond;
  };
  /// A pair with a fast particle, which are farther apart than the list is to reach with the common skin.
  struct FarPair {
    std::uint32_t particle, other;
    auto operator<=>(const FarPair&) const = default;
  };
  bool has_moved_by_skin(const DisplacementExtremes& of_own);
  bool fast_have_moved(std::span<const ContactingBody> bodies, const DisplacementExtremes& of_others) const;
  bool is_exposed(const Member& member) const {
    return member.is_foreign ? foreign_states_[member.slot].is_exposed != 0 : exposures_[member.body].is_exposed(member.slot);
  }
  void list_particles(std::span<const ContactingBody> bodies);
  void find_foreign(std::span<const ContactingBody> bodies);
  void choose_fast(std::span<const ContactingBody> bodies);
  void list_runs();
  void mark_cells();
  double squared_reference_distance(std::size_t p, std::size_t q) const { return squared_norm(reference_positions_.at(q) - reference_positions_.at(p)); }
  bool has_lost(const Member& particle) const {
    return particle.is_foreign ? foreign_.all()[particle.slot].has_lost != 0 : exposures_[particle.body].has_lost(particle.slot);
  }
  std::size_t body_of(std::uint64_t id) const;
  double reach_of(const Member& i, const Member& j) const { return weight_reach * (law_.distance_ratio * (0.5 * (i.size + j.size))); }
  void find_far_pairs();
  std::span<const FarPair> far_pairs_of(std::size_t particle) const;
  std::size_t find_pairs(std::span<const ContactingBody> bodies);
  void list_members();
  void find_of(std::size_t particle, std::span<const ContactingBody> bodies, std::vector<Found>& found) const;
  void name_bonds(std::size_t particle, std::span<const ContactingBody> bodies, std::span<Found> found) const;

  ShortRangeLaw law_;
  double skin_ = 0, longest_ = 0;         // [m] skin, contact distance
  std::vector<double> bonded_within_;     // [m] of each body: two of its particles nearer than this in the reference configuration have had a bond
  std::vector<Exposure> exposures_;       // of each body; empty until the next step derives them
  std::vector<Share> shares_;             // of each body
  std::vector<std::uint64_t> first_ids_;  // of each body

  // of all particles of all bodies, with those of other ranks, by id
  std::vector<Member> particles_;
  VectorArray reference_positions_;                      // [m] positions when the list was built
  std::vector<ParticleRun> runs_;                        // all own particles but the fast ones, when the list was built
  Vec3d drift_{};                                        // [m] approximate common displacement since
  std::vector<std::uint8_t> near_damage_;                // near a particle that has lost a bond
  std::vector<std::uint32_t> member_of_;                 // none if it has no pairs
  std::vector<std::vector<std::uint32_t>> particle_at_;  // of body and slot; none if the list does not concern it

  ForeignParticles foreign_;
  std::vector<ForeignState> foreign_states_;
  std::vector<std::uint32_t> own_particles_, foreign_particles_;  // particle of each own and foreign one; empty in a run of one rank

  FastParticles fast_;
  bool has_fast_ = true;
  std::vector<FarPair> far_pairs_;  // ascending, each from both ends

  WrappedCells cells_;
  std::vector<std::uint8_t> cell_marks_;
  std::vector<std::uint32_t> cell_bodies_;  // body of all particles of a cell; none if it has several, or no particles
  VectorArray references_by_cell_;          // [m] X, in the order of cells_.points_by_cell()

  std::vector<std::uint32_t> counts_;        // of all particles: their pairs
  std::vector<std::size_t> first_of_block_;  // of each block of particles: its first pair

  std::vector<Member> members_;
  std::vector<std::size_t> first_pair_;                       // of each member
  std::size_t pair_count_ = 0;                                // others_ and bonds_ have room for more
  std::vector<std::uint32_t> pair_counts_, unbonded_counts_;  // of each member; pairs without an intact bond come first
  std::vector<std::vector<std::uint32_t>> broken_eights_;     // of each body, whose bonds broke in the latest step; empty after make()
  std::vector<std::uint8_t> exposed_;                         // of each member
  std::size_t times_exposed_ = 0;
  fccda::AlignedVector<std::int32_t> others_;  // packs of eight are read
  fccda::AlignedVector<std::uint32_t> bonds_;
  bool is_known_ = false;
  std::size_t times_made_ = 0;
};

template <class T, class ValueOf, class Set>
void NearPairs::refresh_members(const ValueOf& value_of, const Set& set) const {
  if (ranks().size() == 1) return;
  const auto of_own = [&](std::size_t own) {
    const std::uint32_t member = member_of_[own_particles_[own]];
    return member == none ? T{} : value_of(std::size_t{member});
  };
  foreign_.refresh<T>(ranks(), of_own, [&](std::size_t foreign, const T& value) { set(std::size_t{member_of_[foreign_particles_[foreign]]}, value); });
}

}  // namespace perimpact
