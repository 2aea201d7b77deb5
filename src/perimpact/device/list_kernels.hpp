/// Kernels that copy the vectors of listed slots, so that few slots travel where few are needed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/host_device.hpp"

namespace perimpact::device {

/// Slots in a list, each once.
struct SlotList {
  const std::uint32_t* slots;
  std::size_t count;
};

/// From arrays by slot to numbers by place in the list: all of the first array, then of the next.
template <std::size_t arrays>
struct GatherKernel {
  SlotList list;
  std::array<const double*, arrays> by_slot;
  double* numbers;

  FCCDA_HD void operator()(std::size_t place) const {
    const std::size_t slot = list.slots[place];
    for (std::size_t c = 0; c < arrays; ++c) numbers[c * list.count + place] = by_slot[c][slot];
  }
};

/// The reverse, for the components of a vector.
struct ScatterKernel {
  SlotList list;
  const double* numbers;
  std::array<double*, 3> vectors;

  FCCDA_HD void operator()(std::size_t place) const {
    const std::size_t slot = list.slots[place];
    for (std::size_t c = 0; c < 3; ++c) vectors[c][slot] = numbers[c * list.count + place];
  }
};

}  // namespace perimpact::device
