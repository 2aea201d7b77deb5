// Device of CUDA: the first GPU, and the one function of the library.
#include <cuda_runtime.h>

#include <string>
#include <utility>
#include <variant>

#include "base/error.hpp"
#include "perimpact/device/device.hpp"

namespace perimpact {

namespace {

constexpr unsigned threads_of_block = 128;

// So many blocks at a time on a multiprocessor. With 7 a thread may have 72 registers, which suffices without spills; without a number nvcc prefers some
// spills to more registers.
template <class Kernel>
constexpr unsigned least_blocks = device::needs_many_registers<Kernel> ? 1 : 7;

template <class Kernel>
__global__ void __launch_bounds__(threads_of_block, least_blocks<Kernel>) run(const Kernel kernel, std::size_t threads) {
  const std::size_t thread = static_cast<std::size_t>(blockIdx.x) * threads_of_block + threadIdx.x;
  if (thread < threads) kernel(thread);
}

void expect_success(cudaError_t result) {
  if (result != cudaSuccess) throw fccda::RunError("the GPU failed: " + std::string(cudaGetErrorString(result)) + ".");
}

class CudaDevice : public Device {
 public:
  explicit CudaDevice(std::string name) : name_(std::move(name)) {}

  std::string name() const override { return name_; }
  void* allocate(std::size_t bytes) override {
    void* memory = nullptr;
    const cudaError_t result = cudaMalloc(&memory, bytes);
    if (result == cudaErrorMemoryAllocation)
      throw fccda::RunError("the memory of " + name_ + " does not suffice for these bodies; use a larger spacing, or run without --device cuda.");
    expect_success(result);
    return memory;
  }
  void release(void* memory) noexcept override { cudaFree(memory); }
  void upload(void* to, const void* from, std::size_t bytes) override { expect_success(cudaMemcpy(to, from, bytes, cudaMemcpyHostToDevice)); }
  void download(void* to, const void* from, std::size_t bytes) override { expect_success(cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToHost)); }
  void launch(const device::Kernel& kernel, std::size_t threads) override {
    if (threads == 0) return;
    const auto blocks = static_cast<unsigned>((threads + threads_of_block - 1) / threads_of_block);
    std::visit([&](const auto& work) { run<<<blocks, threads_of_block>>>(work, threads); }, kernel);
    expect_success(cudaGetLastError());
  }

 private:
  std::string name_;
};

}  // namespace

}  // namespace perimpact

extern "C" __attribute__((visibility("default"))) perimpact::Device* perimpact_open_device(int version, std::string& reason) {
  if (version != perimpact::device_version) return nullptr;
  int count = 0;
  cudaError_t result = cudaGetDeviceCount(&count);
  cudaDeviceProp properties{};
  if (result == cudaSuccess && count > 0) result = cudaGetDeviceProperties(&properties, 0);
  if (result == cudaSuccess && count > 0) return new perimpact::CudaDevice(properties.name);
  reason = result == cudaSuccess ? "no GPU was found" : cudaGetErrorString(result);
  return nullptr;
}
