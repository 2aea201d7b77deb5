/// The kernels of a device: each is a trivially copyable struct of numbers and pointers into the memory of the device, whose call operator does the work
/// of one thread. A thread has one slot, or one block of slots, and writes only what belongs to it, so that results do not depend on the order of threads.
/// (Only lists of slots do, which the host sorts.)
///
/// The passes over bonds are those of the processor, on packs of one particle: bitwise the same results.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "base/host_device.hpp"
#include "base/typelist.hpp"
#include "perimpact/body/motion_sums.hpp"
#include "perimpact/device/bonds_of_slots.hpp"
#include "perimpact/device/boundary_kernels.hpp"
#include "perimpact/device/correspondence_kernels.hpp"
#include "perimpact/device/elastic_kernels.hpp"
#include "perimpact/device/list_kernels.hpp"
#include "perimpact/device/plastic_device_kernels.hpp"
#include "perimpact/device/short_range_device_kernels.hpp"
#include "perimpact/force/correction_kernels.hpp"
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

/// Momentum and kinetic energies of the particles of one eight.
struct MotionSumsKernel {
  ParticlesView particles;
  std::array<const double*, 3> force;  // [N/m³]
  double density, kick;                // [kg/m³] of inertia, [m³ s/kg]
  MotionSums* sums;

  FCCDA_HD void operator()(std::size_t eight) const {
    MotionSums sum;
    bool is_first = true;
    for (std::size_t slot = eight * fccda::byte_lanes; slot < (eight + 1) * fccda::byte_lanes; ++slot) {
      if (!particles.is_occupied(slot)) continue;
      const auto& v = particles.velocity;
      const MotionSums of_slot =
          motion_of(density * particles.volume(slot), {v[0][slot], v[1][slot], v[2][slot]}, kick * Vec3d{force[0][slot], force[1][slot], force[2][slot]});
      if (is_first)
        sum = of_slot;
      else
        sum += of_slot;
      is_first = false;
    }
    sums[eight] = sum;
  }
};

/// All kernels.
using Kernel =
    fccda::JoinedVariant<AdvanceKernel, TravelKernel, MotionSumsKernel, ListKernels, GatherBondsKernel, BoundaryKernels, ShortRangeKernels,
                         PressedStrengthKernel, ElasticKernels<NoCorrections>, ElasticKernels<Corrections<EnergyFactor, EnergyFactor>>,
                         ElasticKernels<Corrections<VolumeFactor, VolumeFactor>>, ElasticKernels<Corrections<FamilyFactor, PlainBonds, true>>,
                         PlasticKernels<NoCorrections>, ReturnKernels, PlasticKernels<Corrections<EnergyFactor, EnergyFactor>>,
                         PlasticKernels<Corrections<VolumeFactor, VolumeFactor>>, NearnessKernel, CorrespondenceKernels<2>, CorrespondenceKernels<3>>;

static_assert(std::is_trivially_copyable_v<Kernel>, "kernels travel to the device as bytes");

}  // namespace perimpact::device
