/// A body whose advance and internal forces, with bond failure, a device computes.
///
/// The host keeps the state. In each step force densities travel to the device, where particles advance; positions and velocities travel to the host,
/// where contact and boundary conditions may change them, and back; force densities travel to the host, where other forces are added. Bonds stay on the
/// device, and travel in steps in which some break.
#pragma once

#include <cstddef>
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

class BodyOnDevice {
 public:
  /// `body`: of a deck that devices support. Its arrays keep their addresses and sizes.
  BodyOnDevice(Device& device, const Body& body);
  BodyOnDevice(BodyOnDevice&&) noexcept;
  ~BodyOnDevice();

  /// As advance() of the host (particles/advance.hpp).
  void advance(Particles& particles, double dt, std::span<double> travel);
  /// As InternalForce::evaluate() and, if with_energy, evaluate_with_energy(), one particle at a time.
  void evaluate(Body& body, double dt, bool with_energy);
  /// To be called when the state of the body may have been changed otherwise than by contact, boundary conditions or forces of a step.
  void renew();

  /// In a step in which no bond breaks, no energy is sampled and no particle comes near its yield surface: advance() and evaluate().
  static DeviceTraffic traffic_of_step(Body& body);

 private:
  std::unique_ptr<device::BodyPasses> passes_;
};

}  // namespace perimpact
