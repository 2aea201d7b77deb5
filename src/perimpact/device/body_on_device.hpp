/// A body whose advance and internal forces, with bond failure, a device computes.
///
/// Positions, velocities and force densities stay on the device. What the host reads of them is brought to its arrays before, and what it changes is stated:
/// contact and outputs run on the host; boundary conditions: boundary_conditions_on_device.hpp. Bonds stay on the device too; those of slots in which some
/// break travel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "perimpact/body/body.hpp"

namespace perimpact {

class Device;
namespace device {
class BodyPasses;
}

/// Throws SetupError with the key of the first part of the deck that devices do not support.
void expect_supported_by_devices(const Setup& setup);

/// What travels between host and device [byte].
struct DeviceTraffic {
  std::size_t uploaded = 0, downloaded = 0;
  bool operator==(const DeviceTraffic&) const = default;
};

/// Numbers of slots of a body that the host reads and changes in a step, and of those whose bonds it learns.
struct SlotsOnHost {
  std::size_t due = 0;        ///< for which contact with impactors is evaluated; others than the loaded ones
  std::size_t displaced = 0;  ///< by contact, of those due
  std::size_t loaded = 0;     ///< whose force densities the host changes; all, with user forces
  std::size_t broken = 0;     ///< with bonds that break in the step
};

class BodyOnDevice {
 public:
  /// `body`: of a deck that devices support. Its arrays keep their addresses and sizes.
  BodyOnDevice(Device& device, Body& body);
  BodyOnDevice(BodyOnDevice&&) noexcept;
  ~BodyOnDevice();

  /// As advance() of the host (particles/advance.hpp). Afterwards positions and velocities are current on the device alone.
  void advance(Particles& particles, double dt, std::span<double> travel);
  /// As InternalForce::evaluate() and, if with_energy, evaluate_with_energy(), one particle at a time. Afterwards force densities, and pressures of what
  /// yields, are current on the device alone; bonds and energies are on the host.
  void evaluate(Body& body, double dt, bool with_energy);

  /// As Body::motion().
  MotionSums motion(const Body& body, double dt);

  /// Brings positions, velocities and force densities to the arrays of the host, of all slots or of these, unless they are current there; of all slots also
  /// pressures of what yields. Must be called before the host reads or changes them.
  void to_host() const;
  void to_host(std::span<const std::uint32_t> slots) const;

  /// To be called after the host has changed positions and velocities of these slots.
  void moved_on_host(std::span<const std::uint32_t> slots);
  /// To be called after the host has changed force densities, of any slots or of these.
  void loaded_on_host();
  void loaded_on_host(std::span<const std::uint32_t> slots);
  /// To be called when the host may have changed any part of the state of the body, after to_host().
  void renew();

  /// In a step in which no particle comes near its yield surface, and the host reads and changes these slots. Neither this step nor that
  /// before is sampled.
  static DeviceTraffic traffic_of_step(Body& body, const SlotsOnHost& on_host = {});

  device::BodyPasses& passes() { return *passes_; }  ///< for kernels of other parts of a step

 private:
  std::unique_ptr<device::BodyPasses> passes_;
};

}  // namespace perimpact
