/// Files that a killed run or a full disk cannot leave half-written.
///
/// Both classes throw fccda::RunError with the file, the system's reason and what to do; whatever was written before stays whole.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>

namespace perimpact::output {

/// What the operating system calls an open file; closed when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  int close();  ///< 0, or errno: network file systems report a full disk only here

 private:
  int number_;
};

/// A file that appears under its name only when all of it is there: bytes go to `<path>.part`, and finish() syncs and renames it.
/// Until then, and if anything fails, an earlier file of that name stays as it was. The folder must exist.
class WholeFile {
 public:
  explicit WholeFile(std::filesystem::path path);
  ~WholeFile();  ///< removes the part of a file that was never finished

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text) { write(std::as_bytes(std::span(text))); }
  void finish();

 private:
  std::filesystem::path path_, part_;
  Descriptor file_;
};

void write_whole_file(const std::filesystem::path& path, std::string_view text);

/// Why a file of that name cannot be written, if so. Leaves no file; one of that name is lost.
std::error_code try_writing(const std::filesystem::path& path);

/// A file that grows by whole records and can be read meanwhile. A record that does not fit is taken back.
class GrowingFile {
 public:
  explicit GrowingFile(std::filesystem::path path);  ///< starts empty

  void append(std::string_view record);

 private:
  std::filesystem::path path_;
  Descriptor file_;
  std::size_t size_ = 0;  // of all whole records [byte]
};

}  // namespace perimpact::output
