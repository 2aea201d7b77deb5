/// Checksum of an array, to verify it on reading.
#pragma once

#include <cstdint>
#include <string_view>

#include "perimpact/simulation/state_hash.hpp"

namespace perimpact::checkpoint {

inline std::uint64_t fingerprint(std::string_view name, const void* bytes, std::size_t count) {
  StateHash hash;
  hash(name, std::span(static_cast<const std::uint8_t*>(bytes), count));
  return hash.value();
}

}  // namespace perimpact::checkpoint
