/// Arrays aligned to cache lines (64 bytes), large ones in huge pages.
#pragma once

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>
#endif

#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

namespace fccda {

/// Memory of large arrays, which begins at a huge page. Under Linux an array occupies whole small pages, and is given back to the operating system as soon as
/// it is freed. operator new of this alignment, which serves elsewhere, keeps up to another huge page for each array, which counts towards `ulimit -v` and
/// `-d`.
///
/// With sanitizers too, although they do not examine such memory: an array that was made in a library may be freed in a program with other flags.
class MappedPages {
 public:
  static constexpr std::size_t huge_page = 2 * 1024 * 1024;  ///< [byte]

  /// Memory of `bytes`, zero under Linux. Throws std::bad_alloc.
  static void* allocate(std::size_t bytes) {
#if defined(__linux__)
    const std::size_t length = in_pages(bytes);
    void* const mapped = mmap(nullptr, length + huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) throw std::bad_alloc();
    char* const begin = static_cast<char*>(mapped);
    const std::size_t before = (huge_page - reinterpret_cast<std::uintptr_t>(begin) % huge_page) % huge_page;
    char* const memory = begin + before;
    if (before > 0) munmap(begin, before);
    munmap(memory + length, huge_page - before);
#if defined(MADV_HUGEPAGE)
    // complete huge pages only, so that an array occupies no more memory than it is long; without huge pages it is as usable
    madvise(memory, bytes / huge_page * huge_page, MADV_HUGEPAGE);
#endif
    return memory;
#else
    return ::operator new (bytes, std::align_val_t{huge_page});
#endif
  }

  /// Frees memory of allocate(), of the same `bytes`.
  static void free(void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
    munmap(memory, in_pages(bytes));
#else
    ::operator delete (memory, std::align_val_t{huge_page});
#endif
  }

#if defined(__linux__)
 private:
  static std::size_t in_pages(std::size_t bytes) {
    static const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return (bytes + page - 1) / page * page;
  }
#endif
};

/// Allocator of std::vector whose memory begins at a cache line. That of an array of 2 MiB or more begins at a huge page, and the operating system is asked
/// to provide huge pages: scattered access to pages of 4 KiB waits for their addresses (with a step of rubble on ice, a tenth of its time).
template <class T>
struct CacheLineAllocator {
  using value_type = T;                         ///< of the vector
  static constexpr std::size_t alignment = 64;  ///< a cache line [byte]

  CacheLineAllocator() = default;
  /// Allocators of all types are interchangeable.
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  /// Memory for `count` values, without construction. Throws std::bad_alloc.
  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    return static_cast<T*>(bytes < MappedPages::huge_page ? ::operator new (bytes, std::align_val_t{alignment}) : MappedPages::allocate(bytes));
  }
  /// Frees memory of allocate(), of the same count.
  void deallocate(T* pointer, std::size_t count) {
    if (const std::size_t bytes = count * sizeof(T); bytes < MappedPages::huge_page)
      ::operator delete (pointer, std::align_val_t{alignment});
    else
      MappedPages::free(pointer, bytes);
  }
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
