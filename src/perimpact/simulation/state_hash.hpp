/// Hash of the whole state, for bitwise comparison of runs of one binary (thread counts, restarts); never stored as a reference value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

#include "base/state.hpp"

namespace perimpact {

/// A visitor for visit_state. The hash is the sum, modulo 2⁶⁴, of one term for each element of each array, which depends on the name of the array and on
/// index and bytes of the element. Arrays, or parts of them, can therefore be hashed in any order, also by different processes whose hashes are added. Names
/// must be unique.
class StateHash {
 public:
  /// Adds an array, or one number.
  template <class Values>
  void operator()(std::string_view name, Values&& values) {
    add(name, 0, fccda::numbers_in(values));
  }

  /// Adds a part of an array: `values` are its elements from `first_index` on, of at most eight bytes each.
  template <class T, std::size_t extent>
  void add(std::string_view name, std::uint64_t first_index, std::span<T, extent> values) {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= sizeof(std::uint64_t));
    const std::uint64_t key = key_of(name) + first_index;
    std::uint64_t sum = 0;
#pragma omp parallel for schedule(static) reduction(+ : sum) if (values.size() > 100000)
    for (std::size_t k = 0; k < values.size(); ++k) {
      std::uint64_t word = 0;
      std::memcpy(&word, &values[k], sizeof(T));
      sum += mixed(word ^ (key + k) * 0x9e3779b97f4a7c15u);
    }
    hash_ += sum;
  }
  /// Adds the terms of another hash, of other arrays or parts.
  void add(const StateHash& other) { hash_ += other.hash_; }

  std::uint64_t value() const { return hash_; }

 private:
  static std::uint64_t key_of(std::string_view name) {
    std::uint64_t key = 0xcbf29ce484222325u;
    for (const char letter : name) key = mixed(key ^ static_cast<unsigned char>(letter));
    return key;
  }
  // a bijection in which every bit of the word affects every bit of the result (the finaliser of MurmurHash3)
  static std::uint64_t mixed(std::uint64_t word) {
    word = (word ^ word >> 33) * 0xff51afd7ed558ccdu;
    word = (word ^ word >> 33) * 0xc4ceb9fe1a85ec53u;
    return word ^ word >> 33;
  }

  std::uint64_t hash_ = 0;
};

}  // namespace perimpact
