/// Contracts: preconditions of functions. A violated contract is a programming error, never the user's (for those see error.hpp),
/// so the check is off in release builds (CMake option PERIMPACT_CONTRACTS).
#pragma once

#ifdef FCCDA_CONTRACTS
#include <cstdio>
#include <cstdlib>
#define EXPECTS(condition)                                                                    \
  do {                                                                                        \
    if (!(condition)) {                                                                       \
      std::fprintf(stderr, "%s:%d: contract violated: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                           \
    }                                                                                         \
  } while (false)
#else
/// Checks a precondition where contracts are on: if it is violated, prints file and line and aborts. Otherwise `condition` is not evaluated.
#define EXPECTS(condition) static_cast<void>(0)
#endif
