/// A device that is emulated on the host: for tests.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "perimpact/device/device.hpp"

namespace perimpact {

/// Its memory is memory of its own, and begins as bytes of ones (NaN), so that what is not uploaded is noticed; and what is not downloaded is noticed since
/// outdated numbers of the host become NaN. Kernels run block by block, in an order of
/// blocks and of the threads of a block that changes with each launch, so that what depends on the order of threads is noticed too.
class EmulatedDevice : public Device {
 public:
  static constexpr std::size_t threads_of_block = 128;  ///< as on the GPU

  EmulatedDevice() = default;
  EmulatedDevice(const EmulatedDevice&) = delete;
  ~EmulatedDevice() override;

  std::string name() const override { return "emulated on the host"; }
  void* allocate(std::size_t bytes) override;
  void release(void* memory) noexcept override;
  void upload(void* to, const void* from, std::size_t bytes) override;
  void download(void* to, const void* from, std::size_t bytes) override;
  void outdate(std::span<double> of_host) override;
  void launch(const device::Kernel& kernel, std::size_t threads) override;

  struct Copied {
    std::size_t uploaded = 0, downloaded = 0;  ///< [byte]
  };
  const Copied& copied() const { return copied_; }  ///< since construction

 private:
  /// Throws std::logic_error unless the range is within memory of the device.
  void expect_allocated(const void* begin, std::size_t bytes) const;

  std::map<const std::byte*, std::size_t> allocated_;  // [byte] of each
  Copied copied_;
  std::uint64_t launches_ = 0;
};

}  // namespace perimpact
