/// Memory that has been freed, but that the C library keeps for later.
#pragma once

#include <cstdlib>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace fccda {

/// Returns freed memory to the operating system where the C library can. By itself it returns large arrays at once only until a program has freed some of them,
/// and smaller ones only from the end of its heap. To be called after large amounts of small arrays have been freed.
inline void return_freed_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace fccda
