/// The boundary conditions of a body whose particles are on a device (body_on_device.hpp): what a step launches and copies for them.
///
/// Forces, displacements and the sums of them are evaluated there; of each quantity that is summed a number for each eight travels to the host, which adds
/// them exactly, as on the host. Tables are evaluated on the host. So are changes that are rare: the surface of the body where bonds break, and floods. Actions
/// without kernels, such as user forces, run on the host.
#pragma once

#include <memory>
#include <span>

#include "fccda/rigid_body/step.hpp"
#include "perimpact/boundary_conditions/boundary_conditions.hpp"
#include "perimpact/device/body_on_device.hpp"

namespace perimpact {

namespace device {
class BoundaryPasses;
}

class BoundaryConditionsOnDevice {
 public:
  /// Of a body on a lattice. `boundary_conditions` keeps its address and its parts.
  BoundaryConditionsOnDevice(Device& device, BodyOnDevice& on_device, Body& body, BoundaryConditions& boundary_conditions);
  BoundaryConditionsOnDevice(BoundaryConditionsOnDevice&&) noexcept;
  ~BoundaryConditionsOnDevice();

  /// As the functions of BoundaryConditions; add_forces() with update_exposed_surface().
  void impose_displacements(Particles& particles, const fccda::Step& step, std::span<double> travel);
  void add_forces(Body& body, const fccda::Step& next);

  /// Brings what BoundaryConditions::visit_record() visits to the host. Must be called before.
  void record_to_host() const;
  /// To be called when the host may have changed state or record, after record_to_host() where it was the record.
  void renew();

  /// In a step in which no bond breaks and no top is flooded, without user forces.
  static DeviceTraffic traffic_of_step(std::span<const NamedBoundaryCondition> all);

 private:
  std::unique_ptr<device::BoundaryPasses> passes_;
};

}  // namespace perimpact
