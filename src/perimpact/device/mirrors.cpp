#include "perimpact/device/mirrors.hpp"

#include <iterator>

#include "base/contract.hpp"

namespace perimpact::device {

void Mirrors::add(std::span<const std::byte> array) {
  const auto [copy, is_new] = copies_.try_emplace(array.data(), Copy{array.size(), Memory(device_, array.size())});
  EXPECTS(is_new);
  device_.upload(copy->second.memory.get(), array.data(), array.size());
}

const void* Mirrors::find(const void* host) const {
  const auto* const address = static_cast<const std::byte*>(host);
  auto after = copies_.upper_bound(address);
  EXPECTS(after != copies_.begin());
  const auto& [begin, copy] = *std::prev(after);
  EXPECTS(address < begin + copy.bytes);
  return static_cast<const std::byte*>(copy.memory.get()) + (address - begin);
}

}  // namespace perimpact::device
