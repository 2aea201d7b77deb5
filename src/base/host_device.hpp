/// Functions that kernels call both on a processor and on a GPU.
#pragma once

#if defined(__CUDACC__)
/// Compiled for the host and, where nvcc compiles, for the device.
#define FCCDA_HD __host__ __device__
#define FCCDA_COLD
#else
/// Compiled for the host and, where nvcc compiles, for the device.
#define FCCDA_HD
/// Rarely called. A call on a GPU would move what stays in registers to memory, so that there such functions are inlined.
#define FCCDA_COLD [[gnu::noinline, gnu::cold]]
#endif
