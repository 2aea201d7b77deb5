/// Where the bytes of an HDF5 file are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace perimpact::hdf5 {

/// Random access to bytes. Errors are exceptions, RunError of a file.
class Storage {
 public:
  virtual ~Storage() = default;

  virtual void write_at(std::uint64_t offset, std::span<const std::byte> bytes) = 0;  ///< extends it if necessary
  virtual void read_at(std::uint64_t offset, std::span<std::byte> bytes) const = 0;
  virtual void resize(std::uint64_t size) = 0;  ///< truncates, or appends zeros
  virtual std::uint64_t size() const = 0;       ///< [byte]
  virtual void sync() = 0;                      ///< returns once everything is on disk
};

/// An output::WholeFile or output::UpdatedFile, which must outlive it.
template <class File>
class FileStorage final : public Storage {
 public:
  explicit FileStorage(File& file) : file_(file) {}

  void write_at(std::uint64_t offset, std::span<const std::byte> bytes) override { file_.write_at(offset, bytes); }
  void read_at(std::uint64_t offset, std::span<std::byte> bytes) const override { file_.read_at(offset, bytes); }
  void resize(std::uint64_t size) override { file_.resize(size); }
  std::uint64_t size() const override { return file_.size(); }
  void sync() override { file_.sync(); }

 private:
  File& file_;
};

}  // namespace perimpact::hdf5
