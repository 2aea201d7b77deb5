/// Members and pairs of the short-range force as its kernels see them (short_range_kernels.hpp), for host and device.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/host_device.hpp"
#include "base/vec3.hpp"
#include "perimpact/self_contact/pairs_view.hpp"
#include "perimpact/self_contact/short_range_law.hpp"

namespace perimpact {

/// Sums over the pairs of a member, other than its force density; all of them doubles, for exact sums.
struct PairSum {
  double energy = 0, friction_dissipation = 0, damped_work = 0;  ///< [J] half of each pair's
  double compaction = 0;                                         ///< [J]
  double contacts = 0;                                           ///< pairs

  constexpr PairSum& operator+=(const PairSum& other) {
    energy += other.energy, friction_dissipation += other.friction_dissipation, damped_work += other.damped_work;
    compaction += other.compaction, contacts += other.contacts;
    return *this;
  }
};

// rows of four numbers, for gather_rows()
struct PlaceOfMember {
  Vec3d position;  ///< [m]
  double size;     ///< [m] Δ
};
struct MotionOfMember {
  Vec3d velocity;  ///< [m/s]
  double volume;   ///< [m³]
};

/// Distances and weights of pairs by their sizes.
struct PairScale {
  double distance_ratio;  ///< q_d
  bool is_plane;

  template <class T>
  FCCDA_HD T distance_of(T size_i, T size_j) const {
    return T(distance_ratio) * (T(0.5) * (size_i + size_j));
  }
  template <class T>
  FCCDA_HD T weight_of(T size, T distance) const {
    const T ratio = size / distance;
    return is_plane ? ratio : ratio * ratio;
  }
};

/// What the kernels read and write. Of two pointers, the first is for contact of a member with its own body, the second for contact with others.
struct ShortRangeView {
  ShortRangeLaw law;
  Face face;
  PairScale scale;
  bool has_several_bodies, yields;  // yields: fragments of a body are compacted beyond a pressure
  double dt;                        // [s] last step

  PairsView pairs;

  // of the members
  const std::uint32_t* body;
  const std::size_t* first_member;  // of each body, and their number
  const double* mass_density;       // [kg/m³] of each body
  PlaceOfMember* places;
  MotionOfMember* motions;
  std::array<const double*, 2> spring;             // [N/m⁷] k
  std::array<const double*, 2> density_stiffness;  // [J] B
  std::array<double*, 2> pressure;                 // [J] B o
  const double* largest_overlap;                   // [-] o at which its own body yields
  double* threshold;                               // b for contact with its own body
  double* latest_pressure;                         // [J] B o; null where no body yields
  double* energy;                                  // [J] of their density
  double* compaction;                              // [J] in the last step
  std::uint32_t* near_count;
  std::uint8_t* may_slip;  // a tangential spring may be extended: with friction, after contact in the last evaluation

  // of their pairs in range, without gaps, from first_near of each member on. There is room for its pairs without a bond.
  const std::size_t* first_near;
  const std::uint32_t* near_room;
  std::int32_t* near;           // the other members
  std::array<double*, 3> slip;  // [m] extensions of their tangential springs; null without friction
  // of all pairs, from pairs.first_pair on
  std::uint8_t* is_near;  // one bit per pair, of the last evaluation

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    pairs.visit_pointers(visit);
    visit(body), visit(first_member), visit(mass_density), visit(places), visit(motions);
    for (auto* two : {&spring, &density_stiffness})
      for (const double*& pointer : *two) visit(pointer);
    for (double*& pointer : pressure) visit(pointer);
    visit(largest_overlap), visit(threshold), visit(latest_pressure), visit(energy), visit(compaction), visit(near_count), visit(may_slip);
    visit(first_near), visit(near_room), visit(near);
    for (double*& component : slip) visit(component);
    visit(is_near);
  }

  /// One of two pointers, without an index that is not a constant: on a device the view would be copied for it.
  template <class T>
  FCCDA_HD static T* of(const std::array<T*, 2>& two, std::size_t whose) {
    return whose == 0 ? two[0] : two[1];
  }
  FCCDA_HD bool slides() const { return law.friction > 0; }
  FCCDA_HD Vec3d slip_of(std::size_t pair) const { return {slip[0][pair], slip[1][pair], slip[2][pair]}; }
  FCCDA_HD void set_slip(std::size_t pair, const Vec3d& to) const {
    for (std::size_t c = 0; c < 3; ++c) slip[c][pair] = to[c];
  }
  /// [N/m] of two members
  FCCDA_HD double tangential_stiffness(std::size_t i, std::size_t j) const {
    const double* k = of(spring, body[i] == body[j] ? 0 : 1);
    return tangential_share * (0.5 * (k[i] + k[j])) * (motions[i].volume * motions[j].volume);
  }
};

}  // namespace perimpact
