/// Hash of the whole state, for bitwise comparison of runs of one binary (thread counts, restarts); never stored as a reference value.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "base/state.hpp"

namespace perimpact {

/// A visitor for visit_state: mixes names and the bytes of the arrays, eight at a time.
class StateHash {
 public:
  template <class Values>
  void operator()(std::string_view name, Values&& values) {
    const auto numbers = fccda::numbers_in(values);
    mix_bytes(name.data(), name.size());
    mix_bytes(numbers.data(), numbers.size_bytes());
  }
  std::uint64_t value() const { return hash_; }

 private:
  void mix_bytes(const void* from, std::size_t count) {
    const auto* bytes = static_cast<const unsigned char*>(from);
    for (; count >= 8; bytes += 8, count -= 8) {
      std::uint64_t word;
      std::memcpy(&word, bytes, 8);
      mix(word);
    }
    std::uint64_t rest = count;
    for (; count > 0; --count) rest = rest << 8 | *bytes++;
    mix(rest);
  }
  // multiply and fold: each step is a bijection of the hash for a given word, so that no difference is lost at once
  void mix(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x9e3779b97f4a7c15u;
    hash_ ^= std::rotr(hash_, 29);
  }
  std::uint64_t hash_ = 0x6a09e667f3bcc908u;
};

}  // namespace perimpact
