/// Copies of arrays of the host in the memory of a device.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <span>

#include "perimpact/device/device.hpp"

namespace perimpact::device {

/// Memory of a device, released at the end.
class Memory {
 public:
  Memory() = default;
  Memory(Device& device, std::size_t bytes) : memory_(device.allocate(bytes), Release{&device}) {}
  void* get() const { return memory_.get(); }

 private:
  struct Release {
    Device* device;
    void operator()(void* memory) const { device->release(memory); }
  };
  std::unique_ptr<void, Release> memory_{nullptr, Release{nullptr}};
};

/// Values of one type in the memory of a device.
template <class T>
class DeviceArray {
 public:
  DeviceArray() = default;
  DeviceArray(Device& device, std::size_t count) : memory_(device, count * sizeof(T)) {}
  T* data() const { return static_cast<T*>(memory_.get()); }

 private:
  Memory memory_;
};

/// Arrays of the host and their copies, which are found by address. The arrays keep their addresses and sizes.
class Mirrors {
 public:
  explicit Mirrors(Device& device) : device_(device) {}

  /// Makes a copy of the array on the device; none of an empty one.
  template <class T>
  void add(std::span<T> array) {
    if (!array.empty()) add(std::as_bytes(array));
  }

  /// The address in the copy that corresponds to an address in an array, or null to null.
  template <class T>
  T* at(T* host) const {
    return host ? static_cast<T*>(const_cast<void*>(find(host))) : nullptr;
  }
  /// The same of several.
  template <class T, std::size_t count>
  std::array<T*, count> at(std::array<T*, count> host) const {
    for (T*& pointer : host) pointer = at(pointer);
    return host;
  }
  /// The same address, for kernels that write to the copy alone.
  template <class T>
  T* writable(const T* host) const {
    return const_cast<T*>(at(host));
  }
  /// The same of all pointers of a view.
  template <class View>
  View on_device(View view) const {
    view.visit_pointers([&](auto& pointer) { pointer = at(pointer); });
    return view;
  }

  /// Copies a part of an array to the device, or back.
  template <class T>
  void upload(std::span<T> part) const {
    device_.upload(const_cast<void*>(find(part.data())), part.data(), part.size_bytes());
  }
  template <class T>
  void download(std::span<T> part) const {
    device_.download(part.data(), find(part.data()), part.size_bytes());
  }

 private:
  void add(std::span<const std::byte> array);
  const void* find(const void* host) const;

  struct Copy {
    std::size_t bytes;
    Memory memory;
  };
  Device& device_;
  std::map<const std::byte*, Copy> copies_;  // by the beginning of the array of the host
};

}  // namespace perimpact::device
