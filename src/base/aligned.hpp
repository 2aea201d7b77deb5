/// Arrays aligned to cache lines (64 bytes).
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace fccda {

/// Allocator of std::vector whose memory begins at a cache line.
template <class T>
struct CacheLineAllocator {
  using value_type = T;                             ///< of the vector
  static constexpr std::align_val_t alignment{64};  ///< [byte] size of a cache line

  CacheLineAllocator() = default;
  /// Allocators of all types are interchangeable.
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  /// Memory for `count` values, without construction. Throws std::bad_alloc.
  T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), alignment)); }
  /// Frees memory of allocate().
  void deallocate(T* pointer, std::size_t) { ::operator delete(pointer, alignment); }
  /// Always true: there is no state.
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

/// A vector whose data begin at a cache line.
template <class T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

}  // namespace fccda
