/// Contact between fragments of bodies whose particles are on a device (body_on_device.hpp).
///
/// The list of pairs is made on the host, from positions that travel then; the arrays of its members and pairs travel to the device. Between new lists pairs,
/// their tangential springs and densities stay on the device: forces are evaluated there, and sums of eights travel to the host.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "perimpact/device/body_on_device.hpp"
#include "perimpact/self_contact/short_range.hpp"

namespace perimpact {

namespace device {
class ShortRangePasses;
}

class ShortRangeOnDevice {
 public:
  /// Of all bodies of a run.
  ShortRangeOnDevice(Device& device, std::vector<BodyOnDevice*> bodies);
  ShortRangeOnDevice(ShortRangeOnDevice&&) noexcept;
  ~ShortRangeOnDevice();

  /// As ShortRange::add_forces(). Afterwards the state of `contact` is current on the device alone.
  void add_forces(ShortRange& contact, std::span<const ContactingBody> bodies, double dt);
  /// Brings the state to the host; the next step makes a new list. Must be called before ShortRange::visit_state() and forget().
  void to_host(ShortRange& contact);

  /// In a step without a new list, in which no bond breaks.
  static DeviceTraffic traffic_of_step(const ShortRange& contact);

 private:
  std::unique_ptr<device::ShortRangePasses> passes_;
};

}  // namespace perimpact
