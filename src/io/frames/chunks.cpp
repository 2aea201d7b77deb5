#include "io/frames/chunks.hpp"

#include <algorithm>

#include "base/parallel_throwing.hpp"
#include "io/output/deflate.hpp"

namespace perimpact::frames {

namespace {

constexpr std::size_t most_rows = 32768;  // of 3 floats 393 kB: enough chunks for all cores in a frame of 1e6 particles

/// The bytes of the numbers by their significance, as HDF5's shuffle filter: all first bytes, then all second ones, …
std::vector<std::byte> shuffled(std::span<const std::byte> bytes, std::size_t chunk_bytes, std::size_t number_size) {
  std::vector<std::byte> out(chunk_bytes);
  const std::size_t numbers = chunk_bytes / number_size, given = bytes.size() / number_size;
  for (std::size_t plane = 0; plane < number_size; ++plane)
    for (std::size_t i = 0; i < given; ++i) out[plane * numbers + i] = bytes[i * number_size + plane];
  return out;
}

}  // namespace

std::size_t rows_of_chunk(std::size_t count) {
  const std::size_t chunks = std::max<std::size_t>(1, (count + most_rows - 1) / most_rows);
  return std::max<std::size_t>(1, (count + chunks - 1) / chunks);
}

void add_filters(hid_t creation) { H5Pset_shuffle(creation), H5Pset_deflate(creation, output::deflate_level); }

std::vector<std::vector<std::byte>> packed_chunks(std::span<const std::byte> bytes, std::size_t chunk_bytes, std::size_t number_size) {
  std::vector<std::vector<std::byte>> chunks((bytes.size() + chunk_bytes - 1) / chunk_bytes);
  fccda::parallel_for_throwing(static_cast<std::ptrdiff_t>(chunks.size()), [&](std::ptrdiff_t k) {
    const std::size_t first = static_cast<std::size_t>(k) * chunk_bytes;
    chunks[static_cast<std::size_t>(k)] =
        output::deflated(shuffled(bytes.subspan(first, std::min(chunk_bytes, bytes.size() - first)), chunk_bytes, number_size));
  });
  return chunks;
}

}  // namespace perimpact::frames
