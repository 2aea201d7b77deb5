/// Bonds of a lattice in the memory of a device: 32 bonds of a slot are the bits of one word.
///
/// On the host a byte has one bond of eight slots, since a pack evaluates them together. On a device each thread has one slot, and words of its own mean
/// that it neither waits for other threads nor needs atomic operations when bonds break. Words are grouped by 32 slots: what the threads of a warp read
/// together is contiguous.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/host_device.hpp"
#include "perimpact/force/bond_loop.hpp"

namespace perimpact::device {

inline constexpr std::size_t bonds_of_word = 32, slots_of_group = 32;

inline constexpr std::size_t words_of_slot(std::size_t rows) { return (rows + bonds_of_word - 1) / bonds_of_word; }
/// Words of all slots.
inline constexpr std::size_t words_of(std::size_t slots, std::size_t rows) {
  return (slots + slots_of_group - 1) / slots_of_group * slots_of_group * words_of_slot(rows);
}
/// Index of the first word of a slot; the next ones follow at distances of slots_of_group.
FCCDA_HD inline std::size_t first_word(std::size_t slot, std::size_t words) { return slot / slots_of_group * (words * slots_of_group) + slot % slots_of_group; }

/// Bits of the bonds of one slot. Rows are asked for in ascending order.
class BitsOfSlot {
 public:
  FCCDA_HD explicit BitsOfSlot(std::uint32_t* first) : first_(first) {}
  template <class Pack>
  FCCDA_HD unsigned intact(std::size_t row) {
    if (row % bonds_of_word == 0) word_ = first_[row / bonds_of_word * slots_of_group];
    return (word_ >> (row % bonds_of_word)) & 1u;
  }
  FCCDA_HD void clear(std::size_t row, unsigned broken) {
    word_ &= ~(broken << (row % bonds_of_word));
    first_[row / bonds_of_word * slots_of_group] = word_;
  }

 private:
  std::uint32_t* first_;
  std::uint32_t word_ = 0;  // of the latest row
};

/// Bonds of a lattice, as for_each_bond() takes them.
class BondsOfSlots : public BondsAlongStencil<std::uint32_t> {
 public:
  /// In device memory: `words` of all slots, and `offsets` in slots of the bonds of the stencil.
  BondsOfSlots(std::uint32_t* words, const std::ptrdiff_t* offsets, std::size_t rows)
      : BondsAlongStencil(offsets, rows), words_(words), words_of_slot_(static_cast<std::uint32_t>(device::words_of_slot(rows))) {}

  /// The same bonds with other words.
  BondsOfSlots with(std::uint32_t* words) const {
    BondsOfSlots others = *this;
    others.words_ = words;
    return others;
  }
  FCCDA_HD BitsOfSlot bits(std::size_t slot) const { return BitsOfSlot(words_ + first_word(slot, words_of_slot_)); }

  /// As copy_changed_bonds() of the host: the bonds of one slot.
  template <class Pack>
  FCCDA_HD bool copy_changed(const BondsOfSlots& to, std::size_t slot) const {
    bool changed = false;
    const std::size_t first = first_word(slot, words_of_slot_);
    for (std::size_t n = 0; n < words_of_slot_; ++n) {
      const std::size_t at = first + n * slots_of_group;
      if (to.words_[at] == words_[at]) continue;
      to.words_[at] = words_[at];
      changed = true;
    }
    return changed;
  }

 private:
  std::uint32_t* words_;
  std::uint32_t words_of_slot_;
};

/// From the words of all slots to those of the slots in a list: words n of all, then words n + 1; and what their broken bonds released.
struct GatherBondsKernel {
  const std::uint32_t* slots;  // of the list
  std::size_t count;
  std::size_t words_of_slot;
  const std::uint32_t* words;
  const double* fracture;  // [J] by slot
  std::uint32_t* words_of_list;
  double* fracture_of_list;

  FCCDA_HD void operator()(std::size_t place) const {
    const std::size_t slot = slots[place], first = first_word(slot, words_of_slot);
    for (std::size_t n = 0; n < words_of_slot; ++n) words_of_list[n * count + place] = words[first + n * slots_of_group];
    fracture_of_list[place] = fracture[slot];
  }
};

}  // namespace perimpact::device
