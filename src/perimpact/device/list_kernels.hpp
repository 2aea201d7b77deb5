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

/// From arrays by slot to numbers by place in the list: all of x, then y, then z.
struct GatherKernel {
  SlotList list;
  std::array<const double*, 3> vectors;
  double* numbers;

  FCCDA_HD void operator()(std::size_t place) const {
    const std::size_t slot = list.slots[place];
    for (std::size_t c = 0; c < 3; ++c) numbers[c * list.count + place] = vectors[c][slot];
  }
};

/// From two arrays by slot: all of the first, then of the second.
struct GatherPairKernel {
  SlotList list;
  const double *first, *second;
  double* numbers;

  FCCDA_HD void operator()(std::size_t place) const {
    const std::size_t slot = list.slots[place];
    numbers[place] = first[slot], numbers[list.count + place] = second[slot];
  }
};

/// The reverse of GatherKernel.
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
