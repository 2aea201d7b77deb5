/// Arrays aligned to cache lines (64 bytes).
#pragma once

#include <cstddef>
#include <new>
#include <utility>
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

/// The same for arrays that are written before they are read: resize() initialises nothing. The threads that write first also make the operating system
/// provide and clear the memory, which takes longer than the writing and is otherwise done by one thread.
template <class T>
struct UninitialisedAllocator : CacheLineAllocator<T> {
  UninitialisedAllocator() = default;
  /// Allocators of all types are interchangeable.
  template <class U>
  UninitialisedAllocator(const UninitialisedAllocator<U>&) {}

  /// Default-initialises a value, which leaves a number as it is.
  template <class U>
  void construct(U* value) {
    ::new (static_cast<void*>(value)) U;
  }
  /// Constructs a value from arguments.
  template <class U, class... Arguments>
  void construct(U* value, Arguments&&... arguments) {
    ::new (static_cast<void*>(value)) U(std::forward<Arguments>(arguments)...);
  }
};

/// An AlignedVector that resize() does not initialise.
template <class T>
using UninitialisedVector = std::vector<T, UninitialisedAllocator<T>>;

}  // namespace fccda
