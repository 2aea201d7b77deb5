/// Vectors by slot that the host and a device both have, and where they are current.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perimpact/device/device.hpp"
#include "perimpact/device/mirrors.hpp"
#include "perimpact/particles/slot_array.hpp"

namespace perimpact::device {

/// One or several arrays that are read and changed together.
///
/// Each number is current on the host, on the device, or on both. Before it is read on one side it is brought there, and after it was changed there this is
/// stated; nothing travels that is current already. On the device all slots are brought and changed together. On the host they may be listed, each list in
/// any order.
class MirroredVectors {
 public:
  /// Current on the host alone. The arrays have mirrors, and keep their addresses.
  MirroredVectors(Device& device, const Mirrors& mirrors, std::vector<VectorArray*> arrays);

  void to_host();                                      ///< brings all slots
  void to_host(std::span<const std::uint32_t> slots);  ///< brings these; all, if most are missing
  void to_device();

  void changed_on_host();                                      ///< any slots; all were current there
  void changed_on_host(std::span<const std::uint32_t> slots);  ///< these, which were current there
  void changed_on_device();                                    ///< all slots have been written, or were current there and some have been written

  /// True if all slots travel rather than these, of which each takes its number along.
  static bool is_most(std::size_t listed, std::size_t slots) { return 2 * listed > slots; }

 private:
  SlotList upload_list(std::span<const std::uint32_t> slots);
  void gather(std::span<const std::uint32_t> slots);
  void scatter(std::span<const std::uint32_t> slots);

  Device* device_;
  const Mirrors* mirrors_;
  std::vector<VectorArray*> arrays_;
  std::size_t slots_;
  bool is_on_host_ = true, is_on_device_ = false;  // current there: all slots, and all but the pending ones
  std::vector<std::uint8_t> is_here_;              // where is_on_host_ is false: of each slot, whether it is current on the host all the same
  std::vector<std::uint32_t> here_, pending_;      // these slots; those changed on the host since they were last on the device, perhaps repeatedly
  std::size_t capacity_ = 0;                       // slots of the longest list so far, at least
  DeviceArray<std::uint32_t> list_;
  DeviceArray<double> numbers_;     // of the slots in the list, array by array
  std::vector<double> on_the_way_;  // the same on the host
};

}  // namespace perimpact::device
