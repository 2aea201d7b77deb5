/// Atomic and append-safe output files: a killed run or a full disk leaves no partial contents.
///
/// Both classes throw fccda::RunError with the file, the system's reason and a remedy; earlier contents remain intact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

namespace perimpact::output {

/// Owning file descriptor, closed on destruction.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  int close();  ///< returns 0 or errno; network file systems report a full disk only here

 private:
  int number_;
};

/// A file that is replaced atomically: bytes go to `<path>.part`, and finish() syncs and renames it, so that not even a power failure leaves
/// it incomplete. Until then, and on any failure, an earlier file of that name is unchanged. The folder must exist.
class WholeFile {
 public:
  explicit WholeFile(std::filesystem::path path);
  ~WholeFile();  ///< removes the .part file if finish() was not called

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text) { write(std::as_bytes(std::span(text))); }
  /// Writes at an offset, extending the file if necessary. Do not mix with sequential writes afterwards.
  void write_at(std::uint64_t offset, std::span<const std::byte> bytes);
  /// Reads back bytes written at the offset. Throws RunError where the file ends earlier.
  void read_at(std::uint64_t offset, std::span<std::byte> bytes) const;
  void resize(std::uint64_t size);  ///< truncates, or appends zeros
  std::uint64_t size() const;       ///< [byte]
  void sync() {}                    ///< finish() does
  void finish();

 private:
  std::filesystem::path path_, part_;
  Descriptor file_;
};

/// An existing file whose bytes are changed in place.
class UpdatedFile {
 public:
  explicit UpdatedFile(std::filesystem::path path);

  void write_at(std::uint64_t offset, std::span<const std::byte> bytes);  ///< extends the file if necessary
  /// Throws RunError where the file ends earlier.
  void read_at(std::uint64_t offset, std::span<std::byte> bytes) const;
  void resize(std::uint64_t size);  ///< truncates, or appends zeros
  std::uint64_t size() const;       ///< [byte]
  void sync();                      ///< flushes everything to disk

 private:
  std::filesystem::path path_;
  Descriptor file_;
};

void write_whole_file(const std::filesystem::path& path, std::string_view text);

/// Checks the path of a user-specified output file before the computation. Throws InputError where its folder is missing or not writable, or
/// the path is a folder.
void expect_place_for(const std::filesystem::path& path);

/// Writes and removes a trial file; returns the error, if any. An existing file of that name is lost.
std::error_code try_writing(const std::filesystem::path& path);

/// Syncs the directory entries of the folder to disk. Silently does nothing on systems that do not support it.
void sync_folder(const std::filesystem::path& folder);

/// A file that grows by complete records and can be read meanwhile. A record that cannot be written completely is removed.
class GrowingFile {
 public:
  explicit GrowingFile(std::filesystem::path path);  ///< starts empty
  /// Resumes after the first `size` bytes of an existing file; the rest is truncated.
  GrowingFile(std::filesystem::path path, std::uint64_t size);

  void append(std::string_view record);
  void sync();                                  ///< flushes everything to disk
  std::uint64_t size() const { return size_; }  ///< [byte]

 private:
  std::filesystem::path path_;
  Descriptor file_;
  std::uint64_t size_ = 0;  // of all complete records [byte]
};

}  // namespace perimpact::output
