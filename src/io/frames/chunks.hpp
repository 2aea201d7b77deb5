/// Chunks of the arrays in a VTKHDF file: shuffled and deflated here, by all threads, as HDF5's own filters would, which use one.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <span>
#include <vector>

namespace perimpact::frames {

/// Rows of the chunks of an array with `count` rows in a step, which fill a whole number of chunks but for a few rows. At least 1.
std::size_t rows_of_chunk(std::size_t count);

/// Adds the filters that packed_chunks applies to the creation properties of a data set.
void add_filters(hid_t creation);

/// Splits an array of numbers of `number_size` bytes into chunks, the last one filled with zeros, and packs each.
std::vector<std::vector<std::byte>> packed_chunks(std::span<const std::byte> bytes, std::size_t chunk_bytes, std::size_t number_size);

}  // namespace perimpact::frames
