#include "io/output/appended.hpp"

#include <algorithm>

#include "base/parallel_throwing.hpp"
#include "io/output/deflate.hpp"
#include "io/output/file.hpp"

namespace perimpact::output {

namespace {

constexpr std::size_t block_size = 1 << 18;  // gives enough blocks for all cores in a frame of 1e5 particles; readers accept any size

}  // namespace

std::uint64_t Appended::add(std::span<const std::byte> bytes) {
  Array array;
  std::uint64_t stored = bytes.size();
  if (compression_ == Compression::none) {
    array.sizes = {bytes.size()};
    array.bytes = bytes;
  } else {
    array.blocks.resize((bytes.size() + block_size - 1) / block_size);
    fccda::parallel_for_throwing(static_cast<std::ptrdiff_t>(array.blocks.size()), [&](std::ptrdiff_t i) {
      const std::size_t first = static_cast<std::size_t>(i) * block_size;
      array.blocks[static_cast<std::size_t>(i)] = deflated(bytes.subspan(first, std::min(block_size, bytes.size() - first)));
    });
    array.sizes = {array.blocks.size(), block_size, bytes.size() % block_size};
    stored = 0;
    for (const auto& block : array.blocks) array.sizes.push_back(block.size()), stored += block.size();
  }
  const std::uint64_t start = end_;
  end_ += array.sizes.size() * sizeof(std::uint64_t) + stored;
  arrays_.push_back(std::move(array));
  return start;
}

void Appended::write_to(WholeFile& file) const {
  for (const Array& array : arrays_) {
    file.write(std::as_bytes(std::span(array.sizes)));
    file.write(array.bytes);
    for (const auto& block : array.blocks) file.write(block);
  }
}

}  // namespace perimpact::output
