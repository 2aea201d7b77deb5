#include "io/output/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace perimpact::output {

namespace fs = std::filesystem;

namespace {

std::string_view remedy(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "Free disk space and run again; everything written before is intact.";
    case EFBIG:
      return "Raise the limit on file sizes (ulimit -f) and run again; everything written before is intact.";
    case EACCES:
    case EPERM:
    case EROFS:
      return "Choose a writable folder.";
    case ENOENT:
    case ENOTDIR:
      return "Its folder does not exist (any more): do not move or delete the results during a run.";
    default:
      return "Everything written before is intact.";
  }
}

[[noreturn]] void fail(const fs::path& path, int error) {
  throw fccda::RunError(fmt::format("{} cannot be written: {}. {}", path.string(), std::strerror(error), remedy(error)));
}

fs::path part_of(const fs::path& path) { return fs::path(path) += ".part"; }

/// Returns -1 on failure, with the reason in errno.
int open_empty(const fs::path& path) { return ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666); }

/// 0, or errno. EINVAL means that the file system does not support syncing, which is not an error.
int sync_file(int file) { return ::fsync(file) == 0 || errno == EINVAL ? 0 : errno; }

/// 0, or errno. A write may be partial (after a signal, or on a full disk): the next call continues or gives the reason.
template <class Write>
int all_of(std::span<const std::byte> bytes, const Write& write) {
  while (!bytes.empty()) {
    const ssize_t written = write(bytes);
    if (written >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

int write_all(int file, std::span<const std::byte> bytes) {
  return all_of(bytes, [&](std::span<const std::byte> rest) { return ::write(file, rest.data(), rest.size()); });
}

void write_at(const fs::path& path, const Descriptor& file, std::uint64_t offset, std::span<const std::byte> bytes) {
  const int error = all_of(bytes, [&](std::span<const std::byte> rest) {
    return ::pwrite(file.number(), rest.data(), rest.size(), static_cast<off_t>(offset + (bytes.size() - rest.size())));
  });
  if (error != 0) fail(path, error);
}

void read_at(const fs::path& path, const Descriptor& file, std::uint64_t offset, std::span<std::byte> bytes) {
  if (::pread(file.number(), bytes.data(), bytes.size(), static_cast<off_t>(offset)) != static_cast<ssize_t>(bytes.size())) fail(path, EIO);
}

void resize(const fs::path& path, const Descriptor& file, std::uint64_t size) {
  if (::ftruncate(file.number(), static_cast<off_t>(size)) != 0) fail(path, errno);
}

std::uint64_t size_of(const fs::path& path, const Descriptor& file) {
  struct stat found {};
  if (::fstat(file.number(), &found) != 0) fail(path, errno);
  return static_cast<std::uint64_t>(found.st_size);
}

}  // namespace

int Descriptor::close() {
  if (!is_open()) return 0;
  return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno;
}

WholeFile::WholeFile(fs::path path) : path_(std::move(path)), part_(part_of(path_)), file_(open_empty(part_)) {
  if (!file_.is_open()) fail(path_, errno);
}

WholeFile::~WholeFile() {
  if (file_.is_open()) ::unlink(part_.c_str());
}

void WholeFile::write(std::span<const std::byte> bytes) {
  if (const int error = write_all(file_.number(), bytes)) fail(path_, error);
}

void WholeFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) { output::write_at(path_, file_, offset, bytes); }
void WholeFile::read_at(std::uint64_t offset, std::span<std::byte> bytes) const { output::read_at(path_, file_, offset, bytes); }
void WholeFile::resize(std::uint64_t size) { output::resize(path_, file_, size); }
std::uint64_t WholeFile::size() const { return size_of(path_, file_); }

void WholeFile::finish() {
  if (const int error = sync_file(file_.number())) fail(path_, error);  // otherwise a power failure could leave a renamed but empty file
  int error = file_.close();
  if (error == 0 && std::rename(part_.c_str(), path_.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(part_.c_str());
    fail(path_, error);
  }
}

UpdatedFile::UpdatedFile(fs::path path) : path_(std::move(path)), file_(::open(path_.c_str(), O_RDWR | O_CLOEXEC)) {
  if (!file_.is_open()) fail(path_, errno);
}

void UpdatedFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) { output::write_at(path_, file_, offset, bytes); }
void UpdatedFile::read_at(std::uint64_t offset, std::span<std::byte> bytes) const { output::read_at(path_, file_, offset, bytes); }
void UpdatedFile::resize(std::uint64_t size) { output::resize(path_, file_, size); }
std::uint64_t UpdatedFile::size() const { return size_of(path_, file_); }

void UpdatedFile::sync() {
  if (const int error = sync_file(file_.number())) fail(path_, error);
}

void write_whole_file(const fs::path& path, std::string_view text) {
  WholeFile file(path);
  file.write(text);
  file.finish();
}

void expect_place_for(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const auto refuse = [&](std::string_view why) { throw fccda::InputError(fmt::format("{} cannot be written: {}", path.string(), why)); };
  if (!fs::exists(folder)) refuse(fmt::format("there is no folder {}. Create it first, or choose another folder.", folder.string()));
  if (!fs::is_directory(folder)) refuse(fmt::format("{} is not a folder. Choose another one.", folder.string()));
  if (fs::is_directory(path)) refuse("it is a folder. Append a file name.");
  if (fs::exists(path) && !fs::is_regular_file(path)) refuse("it is a pipe or a device, not a file. Choose another name.");
  if (::access(folder.c_str(), W_OK) != 0) refuse(fmt::format("the folder {} is not writable. Choose another one.", folder.string()));
}

std::error_code try_writing(const fs::path& path) {
  Descriptor file(open_empty(path));
  int error = file.is_open() ? write_all(file.number(), std::as_bytes(std::span("trial"))) : errno;
  if (const int late = file.close(); error == 0) error = late;
  ::unlink(path.c_str());
  return {error, std::generic_category()};
}

void sync_folder(const fs::path& folder) {
  Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.is_open()) ::fsync(opened.number());
}

GrowingFile::GrowingFile(fs::path path) : path_(std::move(path)), file_(open_empty(path_)) {
  if (!file_.is_open()) fail(path_, errno);
}

GrowingFile::GrowingFile(fs::path path, std::uint64_t size)
    : path_(std::move(path)), file_(::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)), size_(size) {
  if (!file_.is_open() || ::ftruncate(file_.number(), static_cast<off_t>(size)) != 0) fail(path_, errno);
}

void GrowingFile::sync() {
  if (const int error = sync_file(file_.number())) fail(path_, error);
}

void GrowingFile::append(std::string_view record) {
  if (const int error = write_all(file_.number(), std::as_bytes(std::span(record)))) {
    // If this fails too, the file ends in a partial record; the error is reported in any case.
    [[maybe_unused]] const int not_shortened = ::ftruncate(file_.number(), static_cast<off_t>(size_));
    fail(path_, error);
  }
  size_ += record.size();
}

}  // namespace perimpact::output
