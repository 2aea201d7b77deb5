/// Changes of an HDF5 file that leave it readable at every moment.
#pragma once

#include <map>
#include <vector>

#include "io/hdf5/storage.hpp"

namespace perimpact::hdf5 {

/// Collects the changes of one session of HDF5 on an existing file. Bytes behind its end are written immediately: no reader looks there. All
/// others are kept in memory until commit(), which HDF5 must precede by closing the file, and writes them in this order:
///
///   1  the superblock, whose end of file then includes the new bytes
///   2  everything behind the first page: of chunk indices and sizes, where each item has a checksum and is written at once
///   3  the first page, in one write
///
/// A file whose readers find new data only through the first page is therefore whole before and after each single write (vtkhdf.hpp).
class StagedStorage final : public Storage {
 public:
  static constexpr std::uint64_t page = 4096;  ///< [byte] that a write never leaves half done when the process is killed

  explicit StagedStorage(Storage& below) : below_(below), committed_(below.size()), size_(committed_) {}

  void write_at(std::uint64_t offset, std::span<const std::byte> bytes) override;
  void read_at(std::uint64_t offset, std::span<std::byte> bytes) const override;
  void resize(std::uint64_t size) override;
  std::uint64_t size() const override { return size_; }
  void sync() override {}

  void commit();
  /// Removes the bytes behind the end of the file as it was. What else was staged is forgotten.
  void discard();

 private:
  void keep(std::uint64_t offset, std::span<const std::byte> bytes);

  Storage& below_;
  std::uint64_t committed_, size_;                           // [byte]
  std::map<std::uint64_t, std::vector<std::byte>> changes_;  // by offset, all before committed_, none overlapping
};

}  // namespace perimpact::hdf5
