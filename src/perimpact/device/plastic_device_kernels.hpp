/// Kernels of bodies that yield for a device: materials whose force is a PlasticForce. Particles flow on the host.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "base/host_device.hpp"
#include "perimpact/device/bonds_of_slots.hpp"
#include "perimpact/device/lattice_tiles.hpp"
#include "perimpact/device/list_kernels.hpp"
#include "perimpact/device/visits.hpp"
#include "perimpact/materials/ordinary_state/plastic_kernels.hpp"

namespace perimpact::device {

using PlasticView = plastic::BodyView<BondsOfSlots, plastic::StencilConstants>;

/// Which slots a kernel evaluates, and where its results go; in device memory.
struct PlasticSlots {
  const std::uint8_t* is_plastic;  // of each eight, as in PlasticForce
  const std::uint8_t* affected;    // of each eight; null: all are evaluated
  std::array<double*, 3> force;    // [N/m³]
  std::array<double*, 6> stress;   // [Pa]
  double* pressure;                // [Pa]
  double* density;                 // [J/m³] of energy
  std::uint8_t* is_hot;            // of each slot: its stress is evaluated

  FCCDA_HD bool includes(std::size_t slot, bool plastic) const {
    const std::size_t eight = slot / fccda::byte_lanes;
    return (is_plastic[eight] != 0) == plastic && (!affected || affected[eight] != 0);
  }
};

/// Whether bonds break in a pass: those beyond their limit are noted alone, in the first visit.
struct Notes {
  static constexpr bool may_break = true;
  unsigned* noted;
  template <class Pack, bool is_plastic, class View>
  FCCDA_HD Noting<plastic::BreakUnderPressure<Pack, is_plastic, View>> breaker(const View& body, const plastic::Strains<Pack, is_plastic, View>& strains,
                                                                               std::size_t slot) const {
    return {{body, strains, slot, {}}, noted};
  }
};

/// A pass in which bonds hold, and the visits of one in which they may break.
enum class Visit { only, first, second };

/// Calls evaluate(breaking, fracture), where `breaking` is Holds, Notes or Breaks.
template <Visit visit, class Evaluate>
FCCDA_HD void visit_plastic_bonds(const Findings& findings, std::size_t slot, const Evaluate& evaluate) {
  if constexpr (visit == Visit::only) {
    double none = 0;
    evaluate(plastic::Holds{}, none);
  } else if constexpr (visit == Visit::first) {
    first_visit(findings, slot, [&](unsigned* noted) {
      double none = 0;
      evaluate(Notes{noted}, none);
    });
  } else {
    second_visit(findings, slot, [&](const BeyondLimit& beyond, double& fracture) { evaluate(plastic::Breaks{beyond}, fracture); });
  }
}

/// Elastic dilatation of one particle in an eight with plastic strain, or without.
template <bool is_plastic, Visit visit, class Corrections>
struct PlasticDilatationKernel {
  static constexpr bool needs_many_registers = is_plastic || visit == Visit::second;
  PlasticView body;
  Corrections corrections;
  Findings findings;
  PlasticSlots slots;

  FCCDA_HD void operator()(std::size_t slot) const {
    if (!slots.includes(slot, is_plastic)) return;
    visit_plastic_bonds<visit>(findings, slot, [&](const auto& breaking, double& fracture) {
      with_factors(body, slot, corrections, [&](const auto& view, std::size_t at, const auto& factors) {
        plastic::dilatation_of_pack<double, is_plastic>(view, at, breaking, factors, fracture);
      });
    });
  }
};

/// Force, energy and pressure of one particle, and its stress where there is a dilatation or plastic strain.
template <bool is_plastic, bool has_dilatation, Visit visit, class Corrections>
struct PlasticForceKernel {
  static constexpr bool needs_many_registers = is_plastic || has_dilatation || visit == Visit::second;
  static constexpr bool with_stress = is_plastic || has_dilatation;
  PlasticView body;
  Corrections corrections;
  Findings findings;
  PlasticSlots slots;

  FCCDA_HD void operator()(std::size_t slot) const {
    if (!slots.includes(slot, is_plastic)) return;
    visit_plastic_bonds<visit>(findings, slot, [&](const auto& breaking, double& fracture) {
      const plastic::OfPack<double> of = with_factors(body, slot, corrections, [&](const auto& view, std::size_t at, const auto& factors) {
        return plastic::force_of_pack<double, is_plastic, has_dilatation, with_stress>(view, at, breaking, factors, fracture, slots.stress);
      });
      for (std::size_t c = 0; c < 3; ++c) slots.force[c][slot] = of.force[c];
      slots.pressure[slot] = of.pressure;
      slots.density[slot] = of.energy;
      slots.is_hot[slot] = with_stress;
    });
  }
};

/// Stress of one particle without plastic strain and dilatation, if its energy may reach the yield surface.
template <class Corrections>
struct HotStressKernel {
  static constexpr bool needs_many_registers = true;
  PlasticView body;
  Corrections corrections;
  PlasticSlots slots;
  double elastic_limit;  // [J/m³]

  FCCDA_HD void operator()(std::size_t slot) const {
    if (!slots.includes(slot, false) || !(slots.density[slot] > elastic_limit)) return;
    double none = 0;
    with_factors(body, slot, corrections, [&](const auto& view, std::size_t at, const auto& factors) {
      return plastic::force_of_pack<double, false, false, true>(view, at, plastic::Holds{}, factors, none, slots.stress);
    });
    slots.is_hot[slot] = 1;
  }
};

/// Whether the stress of each slot of one eight is evaluated, as bits.
struct HotBitsKernel {
  const std::uint8_t* is_hot;  // of each slot
  std::uint8_t* bits;          // of each eight

  FCCDA_HD void operator()(std::size_t eight) const {
    unsigned all = 0;
    for (std::size_t lane = 0; lane < fccda::byte_lanes; ++lane) all |= (is_hot[eight * fccda::byte_lanes + lane] != 0 ? 1u : 0u) << lane;
    bits[eight] = static_cast<std::uint8_t>(all);
  }
};

/// What the forces of the step do less after a return, of each place in a list.
struct LostWorkKernel {
  EightList list;
  ParticlesView particles;
  const double* before;              // [N/m³] as GatherKernel<EightList, 3> writes it
  std::array<const double*, 3> now;  // [N/m³] by slot
  double dt;                         // [s]
  double* lost;                      // [J]

  FCCDA_HD void operator()(std::size_t place) const {
    const std::size_t slot = list.slot(place), places = list.places();
    const Vec3d force_before{before[place], before[places + place], before[2 * places + place]};
    lost[place] = plastic::lost_work<double>(particles, slot, force_before, {now[0][slot], now[1][slot], now[2][slot]}, dt);
  }
};

using ReturnKernels = std::variant<HotBitsKernel, LostWorkKernel>;

/// The kernels with a surface correction.
template <class Corrections, bool... is_plastic>
using PlasticKernelsWith = std::variant<
    Tiled<PlasticDilatationKernel<is_plastic, Visit::only, Corrections>>..., Tiled<PlasticDilatationKernel<is_plastic, Visit::first, Corrections>>...,
    Tiled<PlasticDilatationKernel<is_plastic, Visit::second, Corrections>>..., Tiled<PlasticForceKernel<is_plastic, true, Visit::only, Corrections>>...,
    Tiled<PlasticForceKernel<is_plastic, false, Visit::only, Corrections>>..., Tiled<PlasticForceKernel<is_plastic, false, Visit::first, Corrections>>...,
    Tiled<PlasticForceKernel<is_plastic, false, Visit::second, Corrections>>..., Tiled<HotStressKernel<Corrections>>>;
template <class Corrections>
using PlasticKernels = PlasticKernelsWith<Corrections, false, true>;

}  // namespace perimpact::device
