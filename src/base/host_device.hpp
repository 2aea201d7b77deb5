/// Functions that kernels call both on a processor and on a GPU.
#pragma once

#if defined(__CUDACC__)
/// Compiled for the host and, where nvcc compiles, for the device.
#define FCCDA_HD __host__ __device__
#define FCCDA_COLD
#define FCCDA_NOINLINE
#else
/// Compiled for the host and, where nvcc compiles, for the device.
#define FCCDA_HD
/// Rarely called. A call on a GPU would move what stays in registers to memory, so that there such functions are inlined.
#define FCCDA_COLD [[gnu::noinline, gnu::cold]]
/// Large, and called in several places; on a GPU as above.
#define FCCDA_NOINLINE [[gnu::noinline]]
#endif
