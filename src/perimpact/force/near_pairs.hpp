/// Pairs of particles that may touch before the list is made anew: a cache, of which no result depends.
///
/// A pair touches where its particles are nearer than their contact distance, have no intact bond, and at least one of them is exposed
/// (force/exposure.hpp). The list holds every such pair, as long as
///   no two particles have come nearer to one another by more than the skin: their displacements since lie in a box whose diagonal is no
///     longer, so that a flight of all together costs nothing;
///   bonds broke only near particles that had lost one before, where the list holds bonded pairs too.
/// It is made anew in the step in which either ends. Which pairs it holds besides is never felt: pairs that do not touch are skipped, and those
/// that do are in the order of body and slot.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "perimpact/force/exposure.hpp"
#include "perimpact/force/short_range_law.hpp"
#include "perimpact/force/touching_body.hpp"
#include "perimpact/force/wrapped_cells.hpp"

namespace perimpact {

class NearPairs {
 public:
  /// A particle that has pairs.
  struct Member {
    std::uint32_t body, slot;
    Vec3d reference;  ///< [m] X
    double size;      ///< [m] Δ_i
    double volume;    ///< [m³]
    double mass;      ///< [kg]
  };
  struct Pair {
    std::uint32_t other;  ///< member
    std::uint32_t bond;   ///< row of the family of the particle's eight slots where their bond is, if it was intact; else no_bond
  };
  static constexpr std::uint32_t no_bond = std::numeric_limits<std::uint32_t>::max();

  NearPairs(const ShortRangeLaw& law, std::span<const TouchingBody> bodies);

  /// Makes the list anew where that is needed.
  void update(std::span<const TouchingBody> bodies);
  /// Has it made anew at the next update.
  void forget() { is_known_ = false; }

  std::span<const Member> members() const { return members_; }  ///< by body and slot
  std::span<const Pair> pairs_of(std::size_t member) const {
    return {pairs_.data() + first_pair_[member], first_pair_[member + 1] - first_pair_[member]};
  }  ///< by member
  bool is_exposed(const Member& member) const { return exposures_[member.body].is_exposed(member.slot); }
  std::size_t times_made() const { return times_made_; }

 private:
  struct Found {
    std::uint32_t particle, bond;
  };
  bool has_moved_by_skin(std::span<const TouchingBody> bodies) const;
  void make(std::span<const TouchingBody> bodies);
  void mark_cells(std::span<const TouchingBody> bodies);
  void find_of(std::size_t particle, std::span<const TouchingBody> bodies, std::vector<Found>& found) const;
  void name_bonds(std::size_t particle, std::span<const TouchingBody> bodies, std::span<Found> found) const;

  ShortRangeLaw law_;
  double skin_ = 0;   // [m]
  double reach_ = 0;  // [m] longest contact distance and skin
  std::vector<Exposure> exposures_;

  // of all particles of all bodies, by body and slot
  std::vector<Member> particles_;
  std::vector<Vec3d> then_;                              // [m] where they were when the list was made
  std::vector<std::uint8_t> stirred_;                    // near one that has lost a bond
  std::vector<std::vector<std::uint32_t>> particle_at_;  // of body and slot

  WrappedCells cells_;
  std::vector<std::uint8_t> cell_marks_;

  std::vector<Member> members_;
  std::vector<std::size_t> first_pair_;
  std::vector<Pair> pairs_;
  bool is_known_ = false;
  std::size_t times_made_ = 0;
};

/// The contact distance of two particles [m]; `first_distance` [m]: |X_j - X_i| of particles of one body.
inline double contact_distance(const ShortRangeLaw& law, double size_i, double size_j) { return law.distance_ratio * (0.5 * (size_i + size_j)); }
inline double contact_distance(const ShortRangeLaw& law, double size_i, double size_j, double first_distance) {
  return std::fmin(share_of_first_distance * first_distance, law.debris_distance_ratio * (0.5 * (size_i + size_j)));
}

}  // namespace perimpact
