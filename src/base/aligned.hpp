/// Arrays aligned to cache lines (64 bytes), large ones in huge pages.
#pragma once

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace fccda {

/// Allocator of std::vector whose memory begins at a cache line. That of an array of 2 MiB or more begins at a huge page, and the operating system is asked
/// to provide huge pages: scattered access to pages of 4 KiB waits for their addresses (with a step of rubble on ice, a tenth of its time).
template <class T>
struct CacheLineAllocator {
  using value_type = T;                                      ///< of the vector
  static constexpr std::size_t cache_line = 64;              ///< [byte]
  static constexpr std::size_t huge_page = 2 * 1024 * 1024;  ///< [byte]

  CacheLineAllocator() = default;
  /// Allocators of all types are interchangeable.
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  /// Memory for `count` values, without construction. Throws std::bad_alloc.
  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    void* const memory = ::operator new(bytes, alignment_of(bytes));
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    // whole pages only, so that an array occupies no more memory than it is long; without huge pages it is as usable
    if (bytes >= huge_page) madvise(memory, bytes / huge_page * huge_page, MADV_HUGEPAGE);
#endif
    return static_cast<T*>(memory);
  }
  /// Frees memory of allocate(), of the same count.
  void deallocate(T* pointer, std::size_t count) { ::operator delete(pointer, alignment_of(count * sizeof(T))); }
  /// Always true: there is no state.
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }

 private:
  static constexpr std::align_val_t alignment_of(std::size_t bytes) { return std::align_val_t{bytes < huge_page ? cache_line : huge_page}; }
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
