#include "perimpact/device/emulated_device.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <new>
#include <numeric>
#include <random>
#include <span>
#include <stdexcept>
#include <variant>

#include "base/parallel.hpp"

namespace perimpact {

namespace {

constexpr std::align_val_t alignment{256};  // that of cudaMalloc

/// 0 … count - 1 in another order for each seed, the same on every machine.
template <class Number>
void shuffle(std::span<Number> numbers, std::uint64_t seed) {
  std::iota(numbers.begin(), numbers.end(), Number{0});
  std::mt19937_64 random(seed);
  for (std::size_t n = numbers.size(); n > 1; --n) std::swap(numbers[n - 1], numbers[random() % n]);
}

}  // namespace

EmulatedDevice::~EmulatedDevice() {
  while (!allocated_.empty()) release(const_cast<std::byte*>(allocated_.begin()->first));
}

void* EmulatedDevice::allocate(std::size_t bytes) {
  auto* const memory = static_cast<std::byte*>(::operator new(bytes, alignment));
  std::memset(memory, 0xff, bytes);
  allocated_.emplace(memory, bytes);
  return memory;
}

void EmulatedDevice::release(void* memory) noexcept {
  if (allocated_.erase(static_cast<const std::byte*>(memory)) == 1) ::operator delete(memory, alignment);
}

void EmulatedDevice::expect_allocated(const void* begin, std::size_t bytes) const {
  const auto* const first = static_cast<const std::byte*>(begin);
  auto after = allocated_.upper_bound(first);
  if (after == allocated_.begin() || first + bytes > std::prev(after)->first + std::prev(after)->second)
    throw std::logic_error("a copy is not within the memory of the device");
}

void EmulatedDevice::upload(void* to, const void* from, std::size_t bytes) {
  expect_allocated(to, bytes);
  std::memcpy(to, from, bytes);
  copied_.uploaded += bytes;
}

void EmulatedDevice::download(void* to, const void* from, std::size_t bytes) {
  expect_allocated(from, bytes);
  std::memcpy(to, from, bytes);
  copied_.downloaded += bytes;
}

void EmulatedDevice::outdate(std::span<double> of_host) { std::fill(of_host.begin(), of_host.end(), std::numeric_limits<double>::quiet_NaN()); }

void EmulatedDevice::launch(const device::Kernel& kernel, std::size_t threads) {
  std::vector<std::size_t> blocks((threads + threads_of_block - 1) / threads_of_block);
  shuffle(std::span<std::size_t>(blocks), ++launches_);
  std::array<std::uint8_t, threads_of_block> order;
  shuffle(std::span<std::uint8_t>(order), launches_);
  std::visit(
      [&](const auto& work) {
        fccda::parallel_for(static_cast<std::ptrdiff_t>(blocks.size()), [&](std::ptrdiff_t number) {
          const std::size_t first = blocks[static_cast<std::size_t>(number)] * threads_of_block;
          for (const std::uint8_t thread : order)
            if (first + thread < threads) work(first + thread);
        });
      },
      kernel);
}

}  // namespace perimpact
