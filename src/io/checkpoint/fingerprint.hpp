/// Checksum of an array, to verify it on reading.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "perimpact/simulation/state_hash.hpp"

namespace perimpact::checkpoint {

/// `count`: of bytes, which are hashed eight at a time; those that remain are hashed one by one.
inline std::uint64_t fingerprint(std::string_view name, const void* bytes, std::size_t count) {
  using Word = std::array<unsigned char, 8>;
  const std::size_t words = count / sizeof(Word);
  StateHash hash;
  hash.add(name, 0, std::span(static_cast<const Word*>(bytes), words));
  hash.add(name, words, std::span(static_cast<const unsigned char*>(bytes) + words * sizeof(Word), count % sizeof(Word)));
  return hash.value();
}

}  // namespace perimpact::checkpoint
