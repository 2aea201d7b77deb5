/// Kernels of elastic bodies for a device: materials whose force is an OrdinaryStateForce.
#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include "base/host_device.hpp"
#include "perimpact/damage/breakers.hpp"
#include "perimpact/damage/pressed_strength.hpp"
#include "perimpact/device/bonds_of_slots.hpp"
#include "perimpact/device/lattice_tiles.hpp"
#include "perimpact/device/visits.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state_kernels.hpp"

namespace perimpact::device {

/// Calls evaluate(breaker, fracture) in the visit of which the breaker is.
template <class Breaker, class Evaluate>
FCCDA_HD void visit_bonds(const Breaker& breaker, const Findings& findings, std::size_t slot, const Evaluate& evaluate) {
  if constexpr (!Breaker::is_armed) {
    double none = 0;
    evaluate(breaker, none);
  } else if constexpr (is_noting<Breaker>) {
    first_visit(findings, slot, [&](unsigned* noted) {
      double none = 0;
      evaluate(Breaker{breaker.breaker, noted}, none);
    });
  } else {
    second_visit(findings, slot, [&](const BeyondLimit& beyond, double& fracture) { evaluate(breaker.with(beyond), fracture); });
  }
}

using OrdinaryView = ordinary_state::BodyView<BondsOfSlots, ordinary_state::StencilConstants>;

/// θ of one particle.
template <class Breaker, class Corrections>
struct DilatationKernel {
  static constexpr bool needs_many_registers = Breaker::is_armed && !is_noting<Breaker>;
  OrdinaryView body;
  Breaker breaker;
  Corrections corrections;
  Findings findings;

  FCCDA_HD void operator()(std::size_t slot) const {
    visit_bonds(breaker, findings, slot, [&](const auto& breaking, double& fracture) {
      with_factors(body, slot, corrections, [&](const auto& view, std::size_t at, const auto& factors) {
        ordinary_state::dilatation_of_pack<double>(view, at, breaking, factors, fracture);
      });
    });
  }
};

/// Force density of one particle and, if has_energy and stores_energy, its energy.
template <class Breaker, class Corrections, bool has_dilatation, bool has_energy>
struct ForceKernel {
  static constexpr bool needs_many_registers = Breaker::is_armed && !is_noting<Breaker>;
  OrdinaryView body;
  Breaker breaker;
  Corrections corrections;
  Findings findings;
  bool stores_energy;

  FCCDA_HD void operator()(std::size_t slot) const {
    visit_bonds(breaker, findings, slot, [&](const auto& breaking, double& fracture) {
      const double energy = with_factors(body, slot, corrections, [&](const auto& view, std::size_t at, const auto& factors) {
        return ordinary_state::force_of_pack<double, has_dilatation, has_energy>(view, at, breaking, factors, fracture);
      });
      if (has_energy && stores_energy) findings.energy[slot] = energy;
    });
  }
};

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

/// The kernels with a surface correction.
template <class Corrections, class... Breakers>
using ElasticKernelsWith =
    std::variant<Tiled<DilatationKernel<Unbreakable, Corrections>>, Tiled<DilatationKernel<Noting<Breakers>, Corrections>>...,
                 Tiled<DilatationKernel<Breakers, Corrections>>..., Tiled<ForceKernel<Unbreakable, Corrections, true, false>>,
                 Tiled<ForceKernel<Unbreakable, Corrections, true, true>>, Tiled<ForceKernel<Unbreakable, Corrections, false, false>>,
                 Tiled<ForceKernel<Unbreakable, Corrections, false, true>>, Tiled<ForceKernel<Noting<Breakers>, Corrections, false, false>>...,
                 Tiled<ForceKernel<Noting<Breakers>, Corrections, false, true>>..., Tiled<ForceKernel<Breakers, Corrections, false, true>>...>;
template <class Corrections>
using ElasticKernels =
    ElasticKernelsWith<Corrections, BreakInTension<TensionOnStencil>, BreakByStrength<LengthOnStencil, false>, BreakByStrength<LengthOnStencil, true>>;

}  // namespace perimpact::device
