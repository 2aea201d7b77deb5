/// Visits of the bonds of a slot by a device.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "base/host_device.hpp"
#include "perimpact/force/bond_loop.hpp"

namespace perimpact::device {

/// Visits of the bonds of a slot in a pass in which bonds may break. Most slots have no bond beyond its limit, and the code for broken bonds takes twice as
/// many registers: it is therefore left to a second kernel, for the slots in which the first finds such bonds.
enum class Found : std::uint8_t { nothing, beyond_limit };

/// Slots that threads append to in any order, in device memory.
struct GrowingList {
  std::uint32_t* count;
  std::uint32_t* slots;  // room for all

  FCCDA_HD void append(std::size_t slot) const {
#if defined(__CUDA_ARCH__)
    const std::uint32_t place = atomicAdd(count, 1u);
#else
    const std::uint32_t place = std::atomic_ref(*count).fetch_add(1, std::memory_order_relaxed);
#endif
    slots[place] = static_cast<std::uint32_t>(slot);
  }
};

/// What the passes over bonds find for each slot; in device memory.
struct Findings {
  Found* found;
  double* energy;      // [J]
  double* fracture;    // [J] released by bonds that broke; of the slots in the list
  GrowingList broken;  // slots with bonds that broke
};

/// Breaker of the first visit: breaks nothing, but notes whether the breaker would.
template <class Breaker>
struct Noting {
  static constexpr bool is_armed = true;
  Breaker breaker;
  unsigned* noted = nullptr;
  BeyondLimit beyond{};

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    breaker.visit_pointers(visit);
  }
  template <class Pack>
  FCCDA_HD Pack of(std::size_t slot) const {
    return breaker.template of<Pack>(slot);
  }
  template <class Pack, class Neighbour>
  FCCDA_HD unsigned bits(std::size_t index, Pack squared_length, Pack of_i, const Neighbour& j) const {
    *noted |= breaker.bits(index, squared_length, of_i, j);
    return 0;
  }
};
template <class Breaker>
inline constexpr bool is_noting = false;
template <class Breaker>
inline constexpr bool is_noting<Noting<Breaker>> = true;

/// True for kernels that say so: those of the second visit, in which few threads have work, and those that sum tensors.
template <class Kernel>
inline constexpr bool needs_many_registers = requires {
  requires Kernel::needs_many_registers;
};

/// The first visit of the bonds of one slot: evaluate(noted) sets *noted if one of them is beyond its limit.
template <class Evaluate>
FCCDA_HD void first_visit(const Findings& findings, std::size_t slot, const Evaluate& evaluate) {
  unsigned noted = 0;
  evaluate(&noted);
  findings.found[slot] = noted ? Found::beyond_limit : Found::nothing;
}

/// The second visit, where the first has found such bonds: evaluate(beyond, fracture) breaks them, and adds what they release.
template <class Evaluate>
FCCDA_HD void second_visit(const Findings& findings, std::size_t slot, const Evaluate& evaluate) {
  if (findings.found[slot] == Found::nothing) return;
  std::uint32_t broken = 0;
  double fracture = 0;
  evaluate(BeyondLimit{&broken}, fracture);
  if (broken == 0) return;
  findings.fracture[slot] = fracture;
  findings.broken.append(slot);
}

}  // namespace perimpact::device
