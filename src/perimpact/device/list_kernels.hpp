/// Kernels that copy the numbers of listed slots, or of listed eights, so that few slots travel where few are needed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "base/host_device.hpp"
#include "base/pack.hpp"

namespace perimpact::device {

/// Slots in a list, each once.
struct SlotList {
  const std::uint32_t* slots;
  std::size_t count;

  FCCDA_HD std::size_t places() const { return count; }
  FCCDA_HD std::size_t slot(std::size_t place) const { return slots[place]; }
};

/// Eights in a list, each once. Their slots have places, eight after eight.
struct EightList {
  const std::uint32_t* eights;
  std::size_t count;

  FCCDA_HD std::size_t places() const { return count * fccda::byte_lanes; }
  FCCDA_HD std::size_t slot(std::size_t place) const { return std::size_t{eights[place / fccda::byte_lanes]} * fccda::byte_lanes + place % fccda::byte_lanes; }
};

/// From arrays by slot to numbers by place in the list: all of the first array, then of the next.
template <class List, std::size_t arrays>
struct GatherKernel {
  List list;
  std::array<const double*, arrays> by_slot;
  double* numbers;

  FCCDA_HD void operator()(std::size_t place) const {
    const std::size_t slot = list.slot(place);
    for (std::size_t c = 0; c < arrays; ++c) numbers[c * list.places() + place] = by_slot[c][slot];
  }
};

/// The reverse.
template <class List, std::size_t arrays>
struct ScatterKernel {
  List list;
  const double* numbers;
  std::array<double*, arrays> by_slot;

  FCCDA_HD void operator()(std::size_t place) const {
    const std::size_t slot = list.slot(place);
    for (std::size_t c = 0; c < arrays; ++c) by_slot[c][slot] = numbers[c * list.places() + place];
  }
};

using ListKernels = std::variant<GatherKernel<SlotList, 2>, GatherKernel<SlotList, 3>, ScatterKernel<SlotList, 3>, GatherKernel<EightList, 3>,
                                 GatherKernel<EightList, 6>, ScatterKernel<EightList, 1>, ScatterKernel<EightList, 14>>;

}  // namespace perimpact::device
