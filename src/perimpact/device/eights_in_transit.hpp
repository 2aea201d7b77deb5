/// Numbers of listed eights that travel between host and device.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perimpact/device/device.hpp"
#include "perimpact/device/mirrors.hpp"

namespace perimpact::device {

/// Copies from arrays by slot to their mirrors, or back; all slots if most eights are listed. Keeps its buffers for the next list.
class EightsInTransit {
 public:
  EightsInTransit(Device& device, const Mirrors& mirrors, std::size_t slots) : device_(&device), mirrors_(&mirrors), slots_(slots) {}

  template <std::size_t arrays>
  void to_device(std::span<const std::uint32_t> eights, const std::array<const double*, arrays>& by_slot) {
    if (eights.empty()) return;
    if (is_most(eights)) {
      for (const double* array : by_slot) mirrors_->upload(std::span(array, slots_));
      return;
    }
    const EightList list = uploaded(eights, arrays);
    double* to = on_the_way_.data();
    for (const double* array : by_slot)
      for (const std::uint32_t eight : eights) to = std::copy_n(array + first_slot(eight), fccda::byte_lanes, to);
    device_->upload(numbers_.data(), on_the_way_.data(), arrays * list.places() * sizeof(double));
    std::array<double*, arrays> mirrored;
    for (std::size_t a = 0; a < arrays; ++a) mirrored[a] = mirrors_->writable(by_slot[a]);
    device_->launch(ScatterKernel<EightList, arrays>{list, numbers_.data(), mirrored}, list.places());
  }

  template <std::size_t arrays>
  void to_host(std::span<const std::uint32_t> eights, const std::array<double*, arrays>& by_slot) {
    if (eights.empty()) return;
    if (is_most(eights)) {
      for (double* array : by_slot) mirrors_->download(std::span(array, slots_));
      return;
    }
    const EightList list = uploaded(eights, arrays);
    std::array<const double*, arrays> mirrored;
    for (std::size_t a = 0; a < arrays; ++a) mirrored[a] = mirrors_->at(by_slot[a]);
    device_->launch(GatherKernel<EightList, arrays>{list, mirrored, numbers_.data()}, list.places());
    device_->download(on_the_way_.data(), numbers_.data(), arrays * list.places() * sizeof(double));
    const double* from = on_the_way_.data();
    for (double* array : by_slot)
      for (const std::uint32_t eight : eights) std::copy_n(from, fccda::byte_lanes, array + first_slot(eight)), from += fccda::byte_lanes;
  }

 private:
  static std::size_t first_slot(std::uint32_t eight) { return std::size_t{eight} * fccda::byte_lanes; }
  bool is_most(std::span<const std::uint32_t> eights) const { return 2 * eights.size() * fccda::byte_lanes > slots_; }
  /// The list on the device, and room for its numbers on both sides.
  EightList uploaded(std::span<const std::uint32_t> eights, std::size_t arrays) {
    if (const std::size_t needed = arrays * eights.size(); needed > capacity_) {
      capacity_ = std::max(needed, 2 * capacity_);
      list_ = DeviceArray<std::uint32_t>(*device_, capacity_);
      numbers_ = DeviceArray<double>(*device_, capacity_ * fccda::byte_lanes);
      on_the_way_.resize(capacity_ * fccda::byte_lanes);
    }
    device_->upload(list_.data(), eights.data(), eights.size_bytes());
    return {list_.data(), eights.size()};
  }

  Device* device_;
  const Mirrors* mirrors_;
  std::size_t slots_;
  std::size_t capacity_ = 0;  // in eights of one array
  DeviceArray<std::uint32_t> list_;
  DeviceArray<double> numbers_;
  std::vector<double> on_the_way_;  // the same on the host
};

}  // namespace perimpact::device
