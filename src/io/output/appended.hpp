/// Appended data section of a VTK XML file: each array preceded by its sizes, as 64-bit integers.
///
///   plain   [bytes] data
///   zlib    [blocks][block size][size of a last, shorter block, or 0][compressed size of each block…] blocks
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/output/vtp.hpp"

namespace perimpact::output {

class WholeFile;

class Appended {
 public:
  explicit Appended(Compression compression) : compression_(compression) {}

  /// Adds an array and returns its offset. The bytes must remain valid until they are written.
  std::uint64_t add(std::span<const std::byte> bytes);

  void write_to(WholeFile& file) const;

 private:
  struct Array {
    std::vector<std::uint64_t> sizes;
    std::vector<std::vector<std::byte>> blocks;  // with compression
    std::span<const std::byte> bytes;            // without compression
  };

  Compression compression_;
  std::vector<Array> arrays_;
  std::uint64_t end_ = 0;  // end offset of all arrays so far
};

}  // namespace perimpact::output
