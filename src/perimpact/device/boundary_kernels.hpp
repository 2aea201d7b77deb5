/// Kernels of boundary conditions for a device. A thread has one place of listed eights (listed_eights.hpp). What is summed is written as numbers of places,
/// which are added in the order of the host.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "base/host_device.hpp"
#include "base/pack_functions.hpp"
#include "perimpact/boundary_conditions/absorbing/absorbing_kernel.hpp"
#include "perimpact/boundary_conditions/actions/action_kernels.hpp"
#include "perimpact/boundary_conditions/actions/listed_eights.hpp"
#include "perimpact/boundary_conditions/floating/water_kernels.hpp"
#include "perimpact/device/visits.hpp"

namespace perimpact::device {

/// Quantities of places in device memory, one after the other.
struct NumbersOfPlaces {
  double* numbers;
  std::size_t places;

  FCCDA_HD void set(std::size_t quantity, std::size_t place, double number) const { numbers[quantity * places + place] = number; }
  FCCDA_HD void set(std::size_t first, std::size_t place, const Vec3d& vector) const {
    for (std::size_t c = 0; c < 3; ++c) set(first + c, place, vector[c]);
  }
  FCCDA_HD void set(std::size_t place, const ResistanceOfPack<double>& resistance) const {
    set(0, place, resistance.force);
    set(3, place, resistance.work);
  }
};

/// The plain sum over one eight, of one quantity.
struct SumLanesKernel {
  const double* numbers;
  double* sums;
  FCCDA_HD void operator()(std::size_t eight) const { sums[eight] = sum_of_lanes(numbers + eight * fccda::byte_lanes); }
};

/// Arrays of listed particles by place, in device memory.
struct ListedView {
  EightsView eights;
  std::array<const double*, 3> reference;  // [m]
  std::array<double*, 3> position, velocity, force;
  double volume;  // [m³]

  FCCDA_HD bool acts(std::size_t place) const { return bits_at<double>(eights.lanes, place) != 0; }
  FCCDA_HD Vec3d reference_at(std::size_t place) const { return {reference[0][place], reference[1][place], reference[2][place]}; }
};

/// Adds a load. Sums: weight times displacement.
struct LoadKernel {
  ListedView particles;
  const double* weights;
  Vec3d load;
  NumbersOfPlaces sums;

  FCCDA_HD void operator()(std::size_t place) const {
    if (!particles.acts(place)) return sums.set(0, place, Vec3d{});
    const std::size_t slot = particles.eights.slot(place);
    const std::array<double*, 3>&x = particles.position, &f = particles.force;
    const Vec3d loaded = with_load({f[0][slot], f[1][slot], f[2][slot]}, weights[place], particles.volume, load);
    for (std::size_t c = 0; c < 3; ++c) f[c][slot] = loaded[c];
    sums.set(0, place, weights[place] * (Vec3d{x[0][slot], x[1][slot], x[2][slot]} - particles.reference_at(place)));
  }
};

/// Adds weight and buoyancy. Sums: lift and potential.
struct LiftKernel {
  WaterView body;
  NumbersOfPlaces sums;

  FCCDA_HD void operator()(std::size_t place) const {
    const HydrostaticsOfPack<double> of = lift_pack<double>(body, place);
    sums.set(0, place, of.lift), sums.set(1, place, of.potential);
  }
};

/// Lists the dry tops that lie deeper than they stay dry, by their places.
struct DeepTopsKernel {
  WaterView body;
  GrowingList deep;

  FCCDA_HD void operator()(std::size_t place) const {
    if (body.is_dry[place] == 0) return;
    const std::size_t slot = body.eights.slot(place);
    if (body.water.floods(body.particles.position[2][slot], body.heights_at<double>(slot))) deep.append(place);
  }
};

/// W of a column.
struct WetKernel {
  WaterView body;
  FCCDA_HD void operator()(std::size_t column) const { wet_pack<double>(body, column); }
};

/// Applies drag, damping and added mass. Sums: force and work.
struct ResistKernel {
  WaterView body;
  double dt;  // [s]
  NumbersOfPlaces sums;
  FCCDA_HD void operator()(std::size_t place) const { sums.set(place, resist_pack<double>(body, place, dt)); }
};

/// Damps an absorbing layer. Sums: force and work.
struct DampKernel {
  AbsorbingView layer;
  NumbersOfPlaces sums;
  FCCDA_HD void operator()(std::size_t place) const { sums.set(place, damp_pack<double>(layer, place)); }
};

/// Imposes prescribed displacements.
struct ImposeKernel {
  ListedView particles;
  PrescribedMotion motion;

  FCCDA_HD void operator()(std::size_t place) const {
    if (particles.acts(place)) motion.impose(particles.eights.slot(place), particles.reference_at(place), particles.position, particles.velocity);
  }
};

/// The largest distance that the particles of a block of listed eights have travelled.
struct ListedTravelKernel {
  ListedView particles;
  const std::uint32_t* begin;  // first eight of each block
  double dt;                   // [s]
  double* travel;              // [m] of each block

  FCCDA_HD void operator()(std::size_t block) const {
    double furthest = 0;
    const std::array<double*, 3>& v = particles.velocity;
    for (std::size_t place = std::size_t{begin[block]} * fccda::byte_lanes; place < std::size_t{begin[block + 1]} * fccda::byte_lanes; ++place) {
      if (!particles.acts(place)) continue;
      const std::size_t slot = particles.eights.slot(place);
      const Vec3d velocity{v[0][slot], v[1][slot], v[2][slot]};
      furthest = fccda::larger(fccda::square_root(dot(velocity, velocity)) * dt, furthest);
    }
    travel[block] = furthest;
  }
};

/// Replaces the force densities of constrained directions. Sums: reaction.
struct ReactKernel {
  ListedView particles;
  PrescribedMotion motion;
  double scale;  // [kg/(m³ s)]
  NumbersOfPlaces sums;

  FCCDA_HD void operator()(std::size_t place) const {
    Vec3d reaction{};
    if (particles.acts(place)) {
      const std::size_t slot = particles.eights.slot(place);
      for (std::size_t c = 0; c < 3; ++c) {
        if (!motion.constrains[c]) continue;
        double& density = particles.force[c][slot];
        const double wanted = motion.force_density(scale, c, particles.velocity[c][slot]);
        reaction[c] = particles.volume * (wanted - density);
        density = wanted;
      }
    }
    sums.set(0, place, reaction);
  }
};

using BoundaryKernels =
    std::variant<SumLanesKernel, LoadKernel, LiftKernel, DeepTopsKernel, WetKernel, ResistKernel, DampKernel, ImposeKernel, ListedTravelKernel, ReactKernel>;

}  // namespace perimpact::device
