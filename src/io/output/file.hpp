/// Files that a killed run or a full disk cannot leave half-written.
///
/// Both classes throw fccda::RunError with the file, the system's reason and what to do; whatever was written before stays whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

namespace perimpact::output {

/// What the operating system calls an open file; closed when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  int close();  ///< 0, or errno: network file systems report a full disk only here

 private:
  int number_;
};

/// A file that appears under its name only when all of it is there: bytes go to `<path>.part`, and finish() syncs and renames it, so that
/// not even a power cut leaves half of it. Until then, and if anything fails, an earlier file of that name stays as it was. The folder
/// must exist.
class WholeFile {
 public:
  explicit WholeFile(std::filesystem::path path);
  ~WholeFile();  ///< removes the part of a file that was never finished

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text) { write(std::as_bytes(std::span(text))); }
  /// The same anywhere in the file, whose end moves where that is behind it. Nothing else is then to be written in order.
  void write_at(std::uint64_t offset, std::span<const std::byte> bytes);
  /// Reads what was written there. Throws RunError where that is not all there.
  void read_at(std::uint64_t offset, std::span<std::byte> bytes) const;
  void resize(std::uint64_t size);  ///< cuts the end off, or adds zeros
  void finish();

 private:
  std::filesystem::path path_, part_;
  Descriptor file_;
};

void write_whole_file(const std::filesystem::path& path, std::string_view text);

/// For a file that the user named, before the work that it shall hold. Throws InputError where its folder is missing or may not be written
/// to, or a folder has its name.
void expect_place_for(const std::filesystem::path& path);

/// Why a file of that name cannot be written, if so. Leaves no file; one of that name is lost.
std::error_code try_writing(const std::filesystem::path& path);

/// What names the folder holds reaches the disk. Not every system can promise that, and then nothing is said.
void sync_folder(const std::filesystem::path& folder);

/// A file that grows by whole records and can be read meanwhile. A record that does not fit is taken back.
class GrowingFile {
 public:
  explicit GrowingFile(std::filesystem::path path);  ///< starts empty
  /// Goes on behind the first `size` bytes of the file, which must be there; the rest is cut off.
  GrowingFile(std::filesystem::path path, std::uint64_t size);

  void append(std::string_view record);
  void sync();                                  ///< all of it reaches the disk
  std::uint64_t size() const { return size_; }  ///< [byte]

 private:
  std::filesystem::path path_;
  Descriptor file_;
  std::uint64_t size_ = 0;  // of all whole records [byte]
};

}  // namespace perimpact::output
