/// A device that runs the kernels of bodies: a GPU, or its emulation on the host (emulated_device.hpp).
///
/// libperimpact_cuda.so (src/gpu_cuda) is opened at run time and only for a run on a GPU, so that a program without CUDA needs none.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "perimpact/device/kernels.hpp"

namespace perimpact {

/// Every call is completed, as seen by the next one, in the order of the calls. Functions throw RunError where the device fails.
class Device {
 public:
  virtual ~Device() = default;
  virtual std::string name() const = 0;

  virtual void* allocate(std::size_t bytes) = 0;  ///< memory of the device, aligned for numbers of any type
  virtual void release(void* memory) noexcept = 0;
  virtual void upload(void* to, const void* from, std::size_t bytes) = 0;    ///< from the host
  virtual void download(void* to, const void* from, std::size_t bytes) = 0;  ///< to the host; completed on return
  /// To be called when the device has later values of these numbers of the host, which must be downloaded before they are read. Nothing on a GPU; the
  /// emulation overwrites them.
  virtual void outdate(std::span<double>) {}
  /// Calls the kernel for threads 0 … threads - 1, in any order.
  virtual void launch(const device::Kernel& kernel, std::size_t threads) = 0;
};

/// Version of Device and of the kernels: of the program and the library, which must agree.
constexpr int device_version = 8;

/// The function by which the library opens the first device. Returns a new object; nullptr if the library has another version, or with a reason if there is
/// no device.
using OpenDevice = Device*(int version, std::string& reason);
constexpr const char* open_device_name = "perimpact_open_device";

}  // namespace perimpact
