/// Kernels of bodies of a correspondence material for a device: materials whose force is a CorrespondenceForce.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

#include "base/host_device.hpp"
#include "perimpact/device/bonds_of_slots.hpp"
#include "perimpact/device/elastic_kernels.hpp"
#include "perimpact/device/visits.hpp"
#include "perimpact/materials/correspondence/bond_level_kernels.hpp"
#include "perimpact/materials/correspondence/one_point_kernels.hpp"

namespace perimpact::device {

template <std::size_t D>
using CorrespondenceView = correspondence::BodyView<D, BondsOfSlots, correspondence::StencilShapes>;

/// B and c of one particle, with the stabilisations wan and silling.
template <std::size_t D, class Breaker>
struct ResponseKernel {
  static constexpr bool needs_many_registers = true;
  CorrespondenceView<D> body;
  Breaker breaker;
  Findings findings;
  bool stores_energy;

  FCCDA_HD void operator()(std::size_t slot) const {
    visit_bonds(breaker, findings, slot, [&](const auto& breaking, double& fracture) {
      const double density = correspondence::response_of_pack<D, double>(body, slot, breaking, stores_energy, fracture);
      if (stores_energy) findings.energy[slot] = energy_of_pack(density, body.particles, slot);
    });
  }
};

/// F of one particle, with the stabilisation bond-level.
template <std::size_t D, class Breaker>
struct GradientKernel {
  static constexpr bool needs_many_registers = true;
  CorrespondenceView<D> body;
  Breaker breaker;
  Findings findings;

  FCCDA_HD void operator()(std::size_t slot) const {
    visit_bonds(breaker, findings, slot, [&](const auto& breaking, double&) { correspondence::gradient_of_pack<D, double>(body, slot, breaking); });
  }
};

/// Nearness of one eight, also to eights beside it that are as near to broken bonds as `from`.
struct NearnessKernel {
  BondsOfSlots known;
  std::uint8_t from;
  const std::uint8_t* broken;
  std::uint8_t* raised;

  FCCDA_HD void operator()(std::size_t eight) const {
    std::uint8_t nearness = broken[eight];
    for (std::size_t slot = eight * fccda::byte_lanes; slot < (eight + 1) * fccda::byte_lanes; ++slot) {
      BitsOfSlot bits = known.bits(slot);
      for (std::size_t row = 0; row < known.rows(eight) && nearness + 1 < from; ++row)
        if (bits.intact<double>(row) != 0 && broken[known.neighbour<double>(slot, row).slot_of(0) / fccda::byte_lanes] >= from)
          nearness = static_cast<std::uint8_t>(from - 1);
    }
    raised[eight] = nearness;
  }
};

/// F of one particle where bonds have broken, or dF/dt of one near them, as before they broke.
template <std::size_t D>
struct RenewGradientKernel {
  static constexpr bool needs_many_registers = true;
  CorrespondenceView<D> body;
  FCCDA_HD void operator()(std::size_t slot) const {
    if (body.broken[slot / fccda::byte_lanes] >= correspondence::broke_here) correspondence::renew_gradient<D, double>(body.before(), slot);
  }
};
template <std::size_t D>
struct RenewRateKernel {
  static constexpr bool needs_many_registers = true;
  CorrespondenceView<D> body;
  FCCDA_HD void operator()(std::size_t slot) const {
    if (body.broken[slot / fccda::byte_lanes] >= correspondence::beside_changed) correspondence::renew_rate<D, double>(body.before(), slot);
  }
};
/// K⁻¹, F and dF/dt of one particle where bonds have broken.
template <std::size_t D>
struct FollowBrokenKernel {
  static constexpr bool needs_many_registers = true;
  CorrespondenceView<D> body;
  FCCDA_HD void operator()(std::size_t slot) const {
    if (body.broken[slot / fccda::byte_lanes] < correspondence::broke_here) return;
    correspondence::follow_bonds<D, double>(body, slot);
    correspondence::renew_gradient<D, double>(body, slot);
    correspondence::renew_rate<D, double>(body, slot);
  }
};

/// Energy [J] of one particle, or, with_rate, in the middle of the last step, of one whose energy broken bonds change.
template <std::size_t D, bool with_rate>
struct BondLevelEnergyKernel {
  static constexpr bool needs_many_registers = true;
  CorrespondenceView<D> body;
  double* energy;
  FCCDA_HD void operator()(std::size_t slot) const {
    if (with_rate && body.broken[slot / fccda::byte_lanes] < correspondence::changed) return;
    energy[slot] = energy_of_pack(correspondence::bond_level_energy<D, double, with_rate>(body, slot), body.particles, slot);
  }
};

/// The passes after that for F.
template <std::size_t D>
struct BondLevelStressKernel {
  static constexpr bool needs_many_registers = true;
  CorrespondenceView<D> body;
  FCCDA_HD void operator()(std::size_t slot) const { correspondence::bond_level_stress<D, double>(body, slot); }
};
template <std::size_t D>
struct BondLevelReturnKernel {
  static constexpr bool needs_many_registers = true;
  CorrespondenceView<D> body;
  FCCDA_HD void operator()(std::size_t slot) const { correspondence::bond_level_return<D, double>(body, slot); }
};
template <std::size_t D>
struct CorrespondenceForceKernel {
  static constexpr bool needs_many_registers = true;
  CorrespondenceView<D> body;
  FCCDA_HD void operator()(std::size_t slot) const { correspondence::force_of_pack<D, double>(body, slot); }
};

template <std::size_t D, class... Breakers>
using CorrespondenceKernelsWith =
    std::variant<ResponseKernel<D, Unbreakable>, ResponseKernel<D, Noting<Breakers>>..., ResponseKernel<D, Breakers>..., GradientKernel<D, Unbreakable>,
                 GradientKernel<D, Noting<Breakers>>..., GradientKernel<D, Breakers>..., RenewGradientKernel<D>, RenewRateKernel<D>, FollowBrokenKernel<D>,
                 BondLevelEnergyKernel<D, false>, BondLevelEnergyKernel<D, true>, BondLevelStressKernel<D>, BondLevelReturnKernel<D>,
                 CorrespondenceForceKernel<D>>;
/// The kernels in space, or in the plane.
template <std::size_t D>
using CorrespondenceKernels =
    CorrespondenceKernelsWith<D, BreakInTension<TensionOnStencil>, BreakByStrength<LengthOnStencil, false>, BreakByStrength<LengthOnStencil, true>>;

}  // namespace perimpact::device
