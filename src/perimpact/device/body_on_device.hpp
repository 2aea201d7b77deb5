/// The passes over a body by a device: advance, and internal forces with bond failure.
///
/// The host keeps the state. In each step force densities travel to the device, where particles advance; positions and velocities travel to the host,
/// where contact and boundary conditions may change them, and back; force densities travel to the host, where other forces are added. Bonds stay on the
/// device, and travel in steps in which some break.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perimpact/body/body.hpp"
#include "perimpact/device/bonds_of_slots.hpp"
#include "perimpact/device/device.hpp"
#include "perimpact/device/mirrors.hpp"

namespace perimpact {

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

  /// As advance() of the host (particles/advance.hpp).
  void advance(Particles& particles, double dt, std::span<double> travel);
  /// As InternalForce::evaluate() and, if with_energy, evaluate_with_energy(), one particle at a time.
  void evaluate(Body& body, double dt, bool with_energy);
  /// To be called when the state of the body may have been changed otherwise than by contact, boundary conditions or forces of a step.
  void renew() { is_renewed_ = true; }

  /// In a step in which no bond breaks and no energy is sampled: advance() and evaluate().
  static DeviceTraffic traffic_of_step(const Particles& particles);

 private:
  void pass(OrdinaryStateForce& force, Body& body, double dt, bool with_energy, SumsOfEights& sums);
  template <class Visit>
  void for_each_visit(const Breaking& breaking, const Body& body, const Visit& visit);
  void upload_motion(const Particles& particles);
  void upload_bonds(const Family& family);
  void enter_broken(Family& family, SumsOfEights& sums);
  void enter_energy(SumsOfEights& sums, bool in_two_visits);

  Device* device_;
  std::size_t slots_, rows_;
  bool is_renewed_ = false;
  device::Mirrors mirrors_;
  device::DeviceArray<std::uint32_t> words_;  // bonds
  device::DeviceArray<double> travel_, energy_, fracture_;
  device::DeviceArray<device::Found> found_;
  device::DeviceArray<std::uint32_t> any_broken_;
};

}  // namespace perimpact
