/// The kernels of a device: each is a trivially copyable struct of numbers and pointers into the memory of the device, whose call operator does the work
/// of one thread. A thread has one slot, or one block of slots, and writes only what belongs to it, so that results do not depend on the order of threads.
///
/// The passes over bonds are those of the processor, on packs of one particle: bitwise the same results.
#pragma once

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "base/host_device.hpp"
#include "base/typelist.hpp"
#include "perimpact/damage/breakers.hpp"
#include "perimpact/damage/pressed_strength.hpp"
#include "perimpact/device/bonds_of_slots.hpp"
#include "perimpact/force/correction_kernels.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state_kernels.hpp"
#include "perimpact/particles/advance.hpp"

namespace perimpact::device {

/// Advances one particle.
struct AdvanceKernel {
  Motion motion;
  FCCDA_HD void operator()(std::size_t slot) const { advance_pack<double>(motion, slot); }
};

/// The largest distance travelled in the step by the particles of one block (particles/advance.hpp).
struct TravelKernel {
  Motion motion;
  std::size_t slots;
  double* travel;  // [m] of each block

  FCCDA_HD void operator()(std::size_t block) const {
    const std::size_t begin = block * travel_block, end = begin + travel_block < slots ? begin + travel_block : slots;
    double fastest = 0;
    for (std::size_t slot = begin; slot < end; ++slot) fastest = fccda::larger(squared_speed<double>(motion, slot), fastest);
    travel[block] = std::sqrt(fccda::larger(fastest, 0.0)) * motion.dt;
  }
};

/// Visits of the bonds of a slot in a pass in which bonds may break. Most slots have no bond beyond its limit, and the code for broken bonds takes twice as
/// many registers: it is therefore left to a second kernel, for the slots in which the first finds such bonds.
enum class Found : std::uint8_t { nothing, beyond_limit, broken };

/// What the passes over bonds find for each slot; in device memory.
struct Findings {
  Found* found;
  double* energy;             // [J]
  double* fracture;           // [J] released by bonds that broke; where found is broken
  std::uint32_t* any_broken;  // not zero if bonds broke anywhere
};

/// Sets a flag that several threads may set.
FCCDA_HD inline void raise(std::uint32_t* flag) {
#if defined(__CUDA_ARCH__)
  atomicExch(flag, 1u);
#else
  std::atomic_ref(*flag).store(1, std::memory_order_relaxed);
#endif
}

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

/// True for kernels of the second visit, in which few threads have work.
template <class Kernel>
inline constexpr bool is_second_visit = false;

/// Visits the bonds of one slot: evaluate(breaker, fracture) returns its energy [J] and adds what broken bonds release.
template <class Breaker, class Evaluate>
FCCDA_HD void visit_bonds(const Breaker& breaker, const Findings& findings, std::size_t slot, bool with_energy, const Evaluate& evaluate) {
  double fracture = 0, energy = 0;
  if constexpr (!Breaker::is_armed) {
    energy = evaluate(breaker, fracture);
  } else if constexpr (is_noting<Breaker>) {
    unsigned beyond = 0;
    energy = evaluate(Breaker{breaker.breaker, &beyond}, fracture);
    findings.found[slot] = beyond ? Found::beyond_limit : Found::nothing;
  } else {
    if (findings.found[slot] == Found::nothing) return;
    std::uint32_t broken = 0;
    energy = evaluate(breaker.with({&broken}), fracture);
    if (broken != 0) {
      findings.found[slot] = Found::broken;
      findings.fracture[slot] = fracture;
      raise(findings.any_broken);
    }
  }
  if (with_energy) findings.energy[slot] = energy;
}

using OrdinaryView = ordinary_state::BodyView<BondsOfSlots, ordinary_state::StencilConstants>;

/// θ of one particle.
template <class Breaker, class Corrections>
struct DilatationKernel {
  OrdinaryView body;
  Breaker breaker;
  Corrections corrections;
  Findings findings;

  FCCDA_HD void operator()(std::size_t slot) const {
    visit_bonds(breaker, findings, slot, false, [&](const auto& breaking, double& fracture) {
      with_factors(body, slot, corrections, [&](const auto& view, std::size_t at, const auto& factors) {
        ordinary_state::dilatation_of_pack<double>(view, at, breaking, factors, fracture);
      });
      return 0.0;
    });
  }
};

/// Force density of one particle and, if has_energy and stores_energy, its energy.
template <class Breaker, class Corrections, bool has_dilatation, bool has_energy>
struct ForceKernel {
  OrdinaryView body;
  Breaker breaker;
  Corrections corrections;
  Findings findings;
  bool stores_energy;

  FCCDA_HD void operator()(std::size_t slot) const {
    visit_bonds(breaker, findings, slot, has_energy && stores_energy, [&](const auto& breaking, double& fracture) {
      return with_factors(body, slot, corrections, [&](const auto& view, std::size_t at, const auto& factors) {
        return ordinary_state::force_of_pack<double, has_dilatation, has_energy>(view, at, breaking, factors, fracture);
      });
    });
  }
};

template <class Breaker, class Corrections>
inline constexpr bool is_second_visit<DilatationKernel<Breaker, Corrections>> = Breaker::is_armed && !is_noting<Breaker>;
template <class Breaker, class Corrections, bool has_dilatation, bool has_energy>
inline constexpr bool is_second_visit<ForceKernel<Breaker, Corrections, has_dilatation, has_energy>> = Breaker::is_armed && !is_noting<Breaker>;

/// Strength of one particle under its compression, if one of its bonds is beyond the limit of unconfined particles.
struct PressedStrengthKernel {
  BondsOfSlots bonds;
  LengthOnStencil lengths;
  std::array<const double*, 3> position;
  double slope;
  const double* unpressed;  // as in half_strength_under_pressure()
  double* pressed;
  const Found* found;

  FCCDA_HD void operator()(std::size_t slot) const {
    if (found[slot] != Found::nothing) pressed[slot] = half_strength_under_pressure<double>(bonds, lengths, position, slot, slope, unpressed);
  }
};

namespace detail {

template <class Corrections, class... Breakers>
using KernelsWith = std::variant<DilatationKernel<Unbreakable, Corrections>, DilatationKernel<Noting<Breakers>, Corrections>...,
                                 DilatationKernel<Breakers, Corrections>..., ForceKernel<Unbreakable, Corrections, true, false>,
                                 ForceKernel<Unbreakable, Corrections, true, true>, ForceKernel<Unbreakable, Corrections, false, false>,
                                 ForceKernel<Unbreakable, Corrections, false, true>, ForceKernel<Noting<Breakers>, Corrections, false, false>...,
                                 ForceKernel<Noting<Breakers>, Corrections, false, true>..., ForceKernel<Breakers, Corrections, false, true>...>;
template <class Corrections>
using Kernels = KernelsWith<Corrections, BreakInTension<TensionOnStencil>, BreakByStrength<LengthOnStencil, false>, BreakByStrength<LengthOnStencil, true>>;

}  // namespace detail

/// All kernels.
using Kernel = fccda::JoinedVariant<AdvanceKernel, TravelKernel, PressedStrengthKernel, detail::Kernels<NoCorrections>,
                                    detail::Kernels<Corrections<EnergyFactor, EnergyFactor>>, detail::Kernels<Corrections<VolumeFactor, VolumeFactor>>,
                                    detail::Kernels<Corrections<FamilyFactor, PlainBonds, true>>>;

static_assert(std::is_trivially_copyable_v<Kernel>, "kernels travel to the device as bytes");

}  // namespace perimpact::device
