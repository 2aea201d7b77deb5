/// Kernels of contact between fragments for a device (self_contact/short_range_kernels.hpp). A thread has one member of the list, and writes only its own
/// pairs and its own particle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "base/host_device.hpp"
#include "perimpact/device/bonds_of_slots.hpp"
#include "perimpact/device/visits.hpp"
#include "perimpact/self_contact/near_pairs.hpp"
#include "perimpact/self_contact/short_range_kernels.hpp"

namespace perimpact::device {

/// Arrays of a body by slot, in device memory.
struct ArraysOfBody {
  std::array<const double*, 3> position, velocity;
  std::array<double*, 3> force;  // [N/m³]
  const std::uint32_t* words;    // bonds (bonds_of_slots.hpp)
  std::size_t words_of_slot;

  FCCDA_HD Vec3d position_at(std::size_t slot) const { return {position[0][slot], position[1][slot], position[2][slot]}; }
  FCCDA_HD Vec3d velocity_at(std::size_t slot) const { return {velocity[0][slot], velocity[1][slot], velocity[2][slot]}; }
  FCCDA_HD bool is_bonded(std::size_t slot, std::size_t row) const {
    return ((words[first_word(slot, words_of_slot) + row / bonds_of_word * slots_of_group] >> (row % bonds_of_word)) & 1u) != 0;
  }
};

/// A particle of one of the bodies.
struct SlotOfBody {
  std::uint32_t body, slot;
};

inline constexpr std::size_t moved_block = 64;  // particles, or numbers of blocks, of a thread

/// Extremes of the displacements of one in so many particles since the list was built.
struct MovedKernel {
  const ArraysOfBody* bodies;
  const SlotOfBody* particles;
  std::size_t count;
  std::array<const double*, 3> reference;  // [m]
  Vec3d drift;                             // [m]
  DisplacementExtremes* moved;             // of each thread

  FCCDA_HD void operator()(std::size_t block) const {
    DisplacementExtremes all;
    // neighbouring threads read neighbouring particles
    for (std::size_t p = block, blocks = (count + moved_block - 1) / moved_block; p < count; p += blocks) {
      const Vec3d by = bodies[particles[p].body].position_at(particles[p].slot) - Vec3d{reference[0][p], reference[1][p], reference[2][p]};
      all.include({by, by, squared_norm(by - drift)});
    }
    moved[block] = all;
  }
};

/// The same of a block of blocks.
struct MovedTogetherKernel {
  const DisplacementExtremes* of_blocks;
  std::size_t count;
  DisplacementExtremes* moved;

  FCCDA_HD void operator()(std::size_t block) const {
    DisplacementExtremes all;
    for (std::size_t n = block * moved_block; n < (block + 1) * moved_block && n < count; ++n) all.include(of_blocks[n]);
    moved[block] = all;
  }
};

/// Position and velocity of a member.
struct GatherMembersKernel {
  ShortRangeView contact;
  const ArraysOfBody* bodies;
  const std::uint32_t* slots;  // of the members

  FCCDA_HD void operator()(std::size_t m) const {
    const ArraysOfBody& body = bodies[contact.body[m]];
    contact.places[m].position = body.position_at(slots[m]), contact.motions[m].velocity = body.velocity_at(slots[m]);
  }
};

/// Moves the pairs of listed members whose bonds have broken.
struct InsertBrokenPairsKernel {
  ShortRangeView contact;
  const ArraysOfBody* bodies;
  const std::uint32_t* slots;  // of the members
  const std::uint32_t* list;

  FCCDA_HD void operator()(std::size_t place) const {
    const std::size_t m = list[place];
    insert_broken_pairs(contact, m, [&](std::size_t row) { return bodies[contact.body[m]].is_bonded(slots[m], row); });
  }
};

/// Density and pressure of a member.
struct DensityKernel {
  static constexpr bool needs_many_registers = true;
  ShortRangeView contact;
  FCCDA_HD void operator()(std::size_t m) const { evaluate_density<double>(contact, m); }
};

/// Adds the forces of the pairs of a member.
struct PairForcesKernel {
  static constexpr bool needs_many_registers = true;
  ShortRangeView contact;
  const ArraysOfBody* bodies;
  const std::uint32_t* slots;  // of the members
  PairSum* sums;

  FCCDA_HD void operator()(std::size_t m) const {
    PairSum sum;
    const Vec3d force = add_pairs_of<double>(contact, m, sum);
    sums[m] = sum;
    if (sum.contacts == 0) return;
    const Vec3d density = force / contact.motions[m].volume;
    const std::array<double*, 3>& f = bodies[contact.body[m]].force;
    for (std::size_t c = 0; c < 3; ++c) f[c][slots[m]] = f[c][slots[m]] + density[c];
  }
};

/// The plain sum over the members of one eight.
struct SumMembersKernel {
  const std::uint32_t* first_member;  // of each eight with members, and their number
  const PairSum* of_members;
  PairSum* sums;

  FCCDA_HD void operator()(std::size_t eight) const {
    PairSum sum = of_members[first_member[eight]];
    for (std::uint32_t m = first_member[eight] + 1; m < first_member[eight + 1]; ++m) sum += of_members[m];
    sums[eight] = sum;
  }
};

using ShortRangeKernels =
    std::variant<MovedKernel, MovedTogetherKernel, GatherMembersKernel, InsertBrokenPairsKernel, DensityKernel, PairForcesKernel, SumMembersKernel>;

}  // namespace perimpact::device
